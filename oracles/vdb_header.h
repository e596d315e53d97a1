#pragma once

#include <istream>

//! Checks of what a VDB file announces, before OpenVDB believes it: OpenVDB allocates what a length says and
//! reads afterwards. All expect a seekable stream that throws where a read fails, tagged with the version of
//! the file. \throw InputError without the path; std::ios::failure at the end of the file; as OpenVDB.
namespace voroprobe
{

//! At the start of the file: is its version one that OpenVDB reads without a warning on its own? Goes back to
//! the start.
void check_vdb_version(std::istream& file);

//! Passes over a map of metadata.
void skip_vdb_metadata(std::istream& file);

//! Looks at the descriptor of a grid (names and type) and goes back to where it began.
void check_vdb_descriptor(std::istream& file);

enum class VdbTree
{
    kStored,
    kOfAnotherGrid //!< an instance: nothing follows the transform
};

//! Looks at what comes before the tree of a grid (metadata and transform) and goes back to where it began.
void check_vdb_grid_header(std::istream& file, VdbTree tree);

} // namespace voroprobe

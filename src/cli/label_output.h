#pragma once

#include <vector>

#include "cli/labels_run.h"
#include "io/mesh_writer.h"

namespace voroprobe
{

//! Where the meshes of labels go: each to a file of its own, as soon as it is done, or all to one in the end.
class LabelOutput
{
public:
    //! Gives the labels their paths. \throw UsageError where a pattern is needed, or would overwrite itself.
    LabelOutput(const MeshArguments& arguments, MeshFormat format, std::vector<LabelOutcome>& labels);

    //! Makes folders that are not there, and tries whether the files can be written. \throw OutputError
    void prepare() const;

    //! Takes the mesh of a label, in the frame of the output. One at a time. \throw OutputError
    void take(const LabelOutcome& label, TriangleMesh mesh);

    //! After the last. \throw OutputError
    void finish();

private:
    //! To the file of its own.
    void write(const LabelOutcome& label, MeshPart part) const;

    [[nodiscard]] std::vector<std::string> comments() const;

    const MeshArguments& arguments_;
    MeshFormat format_;
    const std::vector<LabelOutcome>& labels_;
    bool one_file_;
    std::vector<MeshPart> parts_; //!< of one file, by label
};

} // namespace voroprobe

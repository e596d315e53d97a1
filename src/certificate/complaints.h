#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "mesh/topology.h"

namespace voroprobe
{

//! What is wrong, in one line: "3 edges on one face only, 1 surface inside out".
class Complaints
{
public:
    //! Nothing where the count is 0.
    void add(std::size_t count, const std::string& one, const std::string& many);

    //! Edges on more than two faces, vertices without one fan, faces that wind against each other.
    void add_crowding(const MeshTopology& topology);

    //! nullopt where there was nothing to complain about.
    [[nodiscard]] std::optional<std::string> text() const;

private:
    std::string text_;
};

} // namespace voroprobe

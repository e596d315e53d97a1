#include <utility>

#include "compare/contestant.h"

namespace voroprobe
{

namespace
{

class GivenMesh final : public Contestant
{
public:
    explicit GivenMesh(TriangleMesh mesh) : mesh_(std::move(mesh)) {}

    void mesh(StageClock& /*clock*/) override {}

    [[nodiscard]] TriangleMesh result() const override { return mesh_; }

private:
    TriangleMesh mesh_;
};

} // namespace

std::unique_ptr<Contestant> make_given(TriangleMesh mesh)
{
    return std::make_unique<GivenMesh>(std::move(mesh));
}

} // namespace voroprobe

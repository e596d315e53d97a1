#include "cli/normals_argument.h"

#include "support/error.h"

namespace voroprobe
{

VertexNormals normals_argument(bool wanted, MeshFormat format)
{
    if (wanted && !holds_normals(format))
        throw UsageError("--normals goes with .ply, .obj and .vtp only");
    return wanted ? VertexNormals::kWritten : VertexNormals::kLeftOut;
}

} // namespace voroprobe

#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "compare/peer_field.h"
#include "mesh/triangle_mesh.h"

//! VTK's surfaces, for the files of this folder alone.
namespace voroprobe
{

//! Isosurface by VTK's FlyingEdges on one thread, wound as VTK does. Frame: that of the field.
vtkSmartPointer<vtkPolyData> flying_edges(const PeerField& field);

//! Vertices on no face are left out, coordinates are those that VTK keeps.
TriangleMesh to_mesh(vtkPolyData& surface);

vtkSmartPointer<vtkPolyData> to_polydata(const TriangleMesh& mesh);

} // namespace voroprobe

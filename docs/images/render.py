#!/usr/bin/python3
"""Draws the picture of README.md from a mesh of ours: the whole on the left, its triangles on the right.

    xvfb-run -a docs/images/render.py out/headsq_bone.stl docs/images/headsq_bone.png

Needs Debian's python3-vtk9 and, without a screen, xvfb.
"""

import sys

import vtk

WIDTH, HEIGHT = 1000, 520
BONE = (0.74, 0.74, 0.74)
EDGE = (0.2, 0.2, 0.2)


def mesh_actor(mesh, show_edges):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(BONE)
    look.SetInterpolationToFlat()
    look.SetAmbient(0.15)
    look.SetSpecular(0.0)
    if show_edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(EDGE)
        look.SetLineWidth(1.0)
    return actor


def view(window, viewport, mesh, target, zoom, show_edges):
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(mesh_actor(mesh, show_edges))
    camera = renderer.GetActiveCamera()
    camera.SetViewUp(0, 0, -1)  # this scan was stored head first
    x, y, z = mesh.GetCenter()
    camera.SetFocalPoint(x, y, z)
    camera.SetPosition(x + 350, y - 500, z - 120)  # from the front, to one side, a little above
    renderer.ResetCamera()
    camera.SetFocalPoint(x + target[0], y + target[1], z + target[2])
    camera.Zoom(zoom)
    window.AddRenderer(renderer)


def main(mesh_path, picture_path):
    reader = vtk.vtkSTLReader()
    reader.SetFileName(mesh_path)
    reader.Update()
    mesh = reader.GetOutput()

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH, HEIGHT)
    view(window, (0.0, 0.0, 0.45, 1.0), mesh, (0, 0, 0), 1.3, False)
    view(window, (0.45, 0.0, 1.0, 1.0), mesh, (15, -60, 5), 3.6, True)
    window.Render()

    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    gray = vtk.vtkImageLuminance()
    gray.SetInputConnection(grab.GetOutputPort())
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(picture_path)
    writer.SetInputConnection(gray.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(*sys.argv[1:])

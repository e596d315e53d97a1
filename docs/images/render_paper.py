#!/usr/bin/python3
"""Draws the pictures of docs/paper.md from meshes of ours: one panel for each mesh, a color for each piece.

    xvfb-run -a docs/images/render_paper.py docs/images/paper_surfaces.png tori.ply implicit.ply

docs/paper.md has the commands that make the meshes. Needs Debian's python3-vtk9 and, without a screen, xvfb.
"""

import sys

import vtk

PANEL_WIDTH, HEIGHT = 400, 370
EDGE = (0.15, 0.15, 0.15)
# Distinct in gray as well (Okabe & Ito 2008).
COLORS = [(0.80, 0.47, 0.65), (0.34, 0.71, 0.91), (0.90, 0.62, 0.0), (0.0, 0.62, 0.45), (0.94, 0.89, 0.26), (0.0, 0.45, 0.70),
          (0.84, 0.37, 0.0)]


def colored_pieces(path):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    pieces = vtk.vtkPolyDataConnectivityFilter()
    pieces.SetInputConnection(reader.GetOutputPort())
    pieces.SetExtractionModeToAllRegions()
    pieces.ColorRegionsOn()
    pieces.Update()
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(len(COLORS))
    for index, color in enumerate(COLORS):
        table.SetTableValue(index, *color, 1.0)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(pieces.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(0, len(COLORS) - 1)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.25)
    look.SetDiffuse(0.75)
    look.SetSpecular(0.0)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(EDGE)
    return actor


def add_panel(window, index, count, path):
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(index / count, 0.0, (index + 1) / count, 1.0)
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(colored_pieces(path))
    camera = renderer.GetActiveCamera()
    camera.SetViewUp(0, 0, 1)
    camera.SetPosition(3, 2, 1.6)
    camera.SetFocalPoint(0, 0, 0)
    renderer.ResetCamera()
    camera.Zoom(1.35)
    window.AddRenderer(renderer)


def main(picture_path, *mesh_paths):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(PANEL_WIDTH * len(mesh_paths), HEIGHT)
    for index, path in enumerate(mesh_paths):
        add_panel(window, index, len(mesh_paths), path)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(picture_path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(*sys.argv[1:])

"""Draws a model's feature edges and its silhouette over a white surface with VTK: MODEL.glb PICTURE.png SIDE."""

import sys

import vtk


def main():
    model, picture, side = sys.argv[1], sys.argv[2], int(sys.argv[3])
    reader = vtk.vtkGLTFReader()
    reader.SetFileName(model)
    surface = vtk.vtkCompositeDataGeometryFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.Update()

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(side, side)
    window.AddRenderer(renderer)

    def add(source, color, width=1.0):
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.ScalarVisibilityOff()
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetLineWidth(width)
        actor.GetProperty().LightingOff()
        renderer.AddActor(actor)

    add(surface, (1, 1, 1))
    renderer.GetActiveCamera().Azimuth(30)
    renderer.GetActiveCamera().Elevation(20)
    renderer.ResetCamera()
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.SetFeatureAngle(34)
    edges.ColoringOff()
    silhouette = vtk.vtkPolyDataSilhouette()
    silhouette.SetInputConnection(surface.GetOutputPort())
    silhouette.SetCamera(renderer.GetActiveCamera())
    silhouette.SetEnableFeatureAngle(0)
    for lines in (edges, silhouette):
        add(lines, (0, 0, 0), 2.0)

    window.Render()
    grabbed = vtk.vtkWindowToImageFilter()
    grabbed.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(grabbed.GetOutputPort())
    writer.Write()


main()

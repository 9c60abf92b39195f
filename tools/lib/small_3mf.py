"""A small 3MF file: a cube."""

import zipfile
from io import BytesIO

MODEL_FILE = "3D/3dmodel.model"
BUILD = '<build><item objectid="1"/></build>'
HEAD = '<?xml version="1.0" encoding="UTF-8"?>'
PACKAGE = "http://schemas.openxmlformats.org/package/2006/"
PLACES = [(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0), (0, 0, 10), (10, 0, 10), (10, 10, 10), (0, 10, 10)]
CORNERS = "321 103 456 674 015 540 126 651 237 762 304 473".split()


def cube(number, places=PLACES, corners=CORNERS):
    """An object of side 10."""
    vertices = "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*p) for p in places)
    triangles = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*c) for c in corners)
    return (f'<object id="{number}" type="model"><mesh><vertices>{vertices}</vertices>'
            f"<triangles>{triangles}</triangles></mesh></object>")


def model(resources, build=BUILD, unit="millimeter"):
    return (f'<model unit="{unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" '
            'xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06">'
            f"<resources>{resources}</resources>{build}</model>")


def files(root):
    """The files of an archive around the XML of its model, by their names."""
    root = root if isinstance(root, bytes) else (HEAD + root).encode()
    return {
        "[Content_Types].xml": f'{HEAD}<Types xmlns="{PACKAGE}content-types"><Default Extension="rels" '
        'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" '
        'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>',
        "_rels/.rels": f'{HEAD}<Relationships xmlns="{PACKAGE}relationships"><Relationship Target="/{MODEL_FILE}" '
        'Id="a" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>',
        MODEL_FILE: root,
    }


def archive(content, method=zipfile.ZIP_DEFLATED):
    """An archive of files, by their names."""
    to = BytesIO()
    with zipfile.ZipFile(to, "w", method) as packed:
        for name, text in content.items():
            packed.writestr(zipfile.ZipInfo(name), text, method)
    return to.getvalue()

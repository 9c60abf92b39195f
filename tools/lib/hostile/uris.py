"""Where buffers lie, and models that are no plain files."""

import os
from pathlib import Path

from lib.hostile.cases import case, quad


def link(target):
    return lambda place: place.symlink_to(target)


def uris():
    def buffer(name, expected, uri):
        model = quad()
        case(f"{name}.gltf", expected, model.document(uri))

    buffer("uri_above_the_folder", "folder", "../secret.bin")
    buffer("uri_above_the_folder_in_code", "folder", "%2e%2e/secret.bin")
    buffer("uri_above_the_folder_late", "folder", "a/b/../../../secret.bin")
    buffer("uri_above_the_folder_backwards", "found", "..\\secret.bin")
    buffer("uri_absolute", "folder", "/etc/passwd")
    buffer("uri_absolute_in_code", "folder", "%2Fetc%2Fpasswd")
    buffer("uri_of_the_network", "folder", "http://localhost/data.bin")
    buffer("uri_of_a_file", "folder", "file:///etc/passwd")
    buffer("uri_through_a_link_out", "link", "link_out.bin")
    buffer("uri_of_a_device", "found", "link_to_device.bin")
    buffer("uri_of_a_folder", "folder", "folder.bin")
    buffer("uri_of_a_pipe", "pipe", "pipe.bin")
    buffer("uri_of_a_link_to_itself", "found", "link_to_itself.bin")
    buffer("uri_of_a_missing_file", "missing.bin", "missing.bin")
    buffer("uri_empty", "found", "")
    buffer("uri_of_the_model_itself", "found", "uri_of_the_model_itself.gltf")
    buffer("uri_with_a_zero_byte", "zero byte", "data%00.bin")
    buffer("uri_with_half_a_code", "hexadecimal", "data%4")
    buffer("uri_of_1_mb", "found", "a" * (1 << 20))
    buffer("uri_with_newline", "found", "a\nb.bin")
    buffer("data_uri_without_comma", "data URI", "data:application/octet-stream;base64")
    buffer("data_uri_not_base64", "data URI", "data:text/plain,hello")
    buffer("data_uri_of_bad_base64", "base64", "data:application/octet-stream;base64,!!!!")
    buffer("data_uri_cut_off", "base64", "data:application/octet-stream;base64,AAAAA")
    buffer("data_uri_too_short", "found", "data:application/octet-stream;base64,AAAA")
    case("uri_a_number.gltf", "uri", quad().document("x").replace(b'"uri":"x"', b'"uri":7'))
    out = Path("/etc/passwd") if Path("/etc/passwd").exists() else Path("/")
    case("link_out.bin", None, link(out))
    case("link_to_device.bin", None, link("/dev/zero"))
    case("link_to_itself.bin", None, link("link_to_itself.bin"))
    case("folder.bin", None, lambda place: place.mkdir())
    case("pipe.bin", None, os.mkfifo)
    case("model_is_a_folder.glb", "folder", lambda place: place.mkdir())
    case("model_is_a_pipe.glb", "pipe", os.mkfifo)
    case("model_is_a_pipe.obj", "pipe", os.mkfifo)
    case("model_is_a_device.glb", "device", link("/dev/zero"))
    case("model_is_a_device.stl", "device", link("/dev/zero"))
    case("model_is_a_link_to_nothing.glb", "none", link("nothing.glb"))

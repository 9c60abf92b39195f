"""Binary glTF that is damaged, and files that are no models."""

import gzip
import struct

from lib.glb import glb_file
from lib.hostile.cases import PICTURE, case, quad


def containers():
    whole = quad().glb()
    text, data = quad().document(), bytes(quad().data)
    case("glb_cut_in_header.glb", "truncated", whole[:10])
    case("glb_cut_after_header.glb", "truncated", whole[:12])
    case("glb_cut_in_chunk_header.glb", "truncated", whole[:17])
    case("glb_cut_in_json.glb", "truncated", whole[:100])
    case("glb_cut_in_data.glb", "truncated", whole[:-5])
    case("glb_of_header_alone.glb", "truncated", struct.pack("<4sII", b"glTF", 2, 12))
    case("glb_says_it_is_longer.glb", "truncated", glb_file(text, data, length=1 << 20))
    case("glb_says_it_is_shorter.glb", "chunk 0", glb_file(text, data, length=40))
    case("glb_says_it_has_no_length.glb", "found", glb_file(text, data, length=0))
    case("glb_json_chunk_of_4_gib.glb", "chunk 0", glb_file(text, data, json_length=0xFFFFFFFF))
    case("glb_json_chunk_too_short.glb", "chunk 1", glb_file(text, data, json_length=50))
    case("glb_json_chunk_empty.glb", "JSON", glb_file(b"", data))
    case("glb_data_chunk_of_4_gib.glb", "chunk 1", glb_file(text, data, data_length=0xFFFFFFFF))
    case("glb_data_chunk_too_short.glb", "buffer 0", glb_file(text, data[:20]))
    case("glb_without_data_chunk.glb", "buffer 0", glb_file(text, None))
    case("glb_data_before_json.glb", "JSON", struct.pack("<4sIII4s", b"glTF", 2, 24, 4, b"BIN\0") + bytes(4))
    case("glb_version_1.glb", "version 1", glb_file(text, data, version=1))
    case("glb_version_3.glb", "version 3", glb_file(text, data, version=3))
    case("glb_with_another_magic.glb", "found", glb_file(text, data, magic=b"GLTF"))
    case("glb_padded_with_zeros.glb", PICTURE, glb_file(text + b"\0\0\0", data))
    case("glb_with_a_third_chunk.glb", PICTURE,
         glb_file(text, data + struct.pack("<I4s", 4, b"ABCD") + bytes(4), data_length=len(data)))
    case("glb_with_more_after_its_end.glb", PICTURE, whole + bytes(100))


def other_kinds():
    case("empty.glb", "empty", b"")
    case("empty.gltf", "empty", b"")
    case("one_byte.glb", "found", b"g")
    case("one_brace.gltf", "JSON", b"{")
    case("text.glb", "text", "hello there\n")
    case("picture.glb", "PNG", b"\x89PNG\r\n\x1a\n" + bytes(100))
    case("page.gltf", "HTML", "<!doctype html><title>404</title>")
    case("archive.glb", "ZIP", b"PK\x03\x04" + bytes(100))
    case("compressed.gltf", "gzip", gzip.compress(quad().gltf(), mtime=0))
    case("git_lfs_pointer.glb", "LFS", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n")
    case("utf16.gltf", "UTF-16", quad().gltf().decode().encode("utf-16"))
    case("byte_order_mark.gltf", PICTURE, b"\xef\xbb\xbf" + quad().gltf())
    case("zeros.glb", "found", bytes(1000))
    case("no_extension", "extension", "hello")
    case("unknown.dwg", "extension", "AC1032")
    case("new\nline.glb", "truncated", b"glTF")

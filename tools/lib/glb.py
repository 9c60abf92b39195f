"""The container of binary glTF 2.0."""

import struct


def glb_file(text, data, *, magic=b"glTF", version=2, length=None, json_length=None, data_length=None):
    """A .glb of a JSON chunk and, unless data is None, a binary chunk, both padded by the caller.

    What a header says can be set apart from what is there, for files that lie.
    """
    chunks = struct.pack("<I4s", len(text) if json_length is None else json_length, b"JSON") + text
    if data is not None:
        chunks += struct.pack("<I4s", len(data) if data_length is None else data_length, b"BIN\0") + data
    return struct.pack("<4sII", magic, version, 12 + len(chunks) if length is None else length) + chunks

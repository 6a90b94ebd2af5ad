"""Image files byte by byte, written and read here: nothing of the program or of its packages makes or reads them."""
import struct
import zlib


def png(width, height, rows, bits=8, kind=2, chunks=(), interlaced=0, packed=None):
    """rows: of all rows their filter and samples; packed: these as zlib has them. chunks: (name, body) before the pixels."""
    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    head = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, interlaced)
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*c) for c in ((b"IHDR", head), *chunks, (b"IDAT", packed or zlib.compress(rows, 1)), (b"IEND", b"")))


def png_chunks(data):
    """(name, body) of each; ValueError where one is damaged."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("not a PNG")
    at = 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if zlib.crc32(name + body) != struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]:
            raise ValueError("damaged chunk")
        yield name, body
        at += 12 + length


def jpeg_segments(data):
    """(marker, body) of each before the first scan; none of other bytes."""
    at = 2
    while data[:2] == b"\xff\xd8" and data[at] == 0xff and data[at + 1] != 0xda:
        length = int.from_bytes(data[at + 2:at + 4], "big")
        yield data[at + 1], data[at + 4:at + 2 + length]
        at += 2 + length


def attribute(name, kind, body):
    """Of an EXR."""
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(body)) + body


def exr_head(names, data, display, kind, extra):
    """kind of the channels: 0 whole numbers, 1 half, 2 float."""
    channels = b"".join(n.encode() + b"\0" + struct.pack("<iBxxxii", kind, 0, 1, 1) for n in sorted(names)) + b"\0"
    return (attribute("channels", "chlist", channels) + attribute("compression", "compression", b"\0") +
            attribute("dataWindow", "box2i", struct.pack("<4i", *data)) + attribute("displayWindow", "box2i", struct.pack("<4i", *display)) +
            attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1)) +
            attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)) +
            attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"".join(extra) + b"\0")


def exr_attributes(data):
    """{name: (kind, body)} of a single-part EXR, and where its table of blocks begins."""
    if data[:4] != b"\x76\x2f\x31\x01":
        raise ValueError("not an EXR")
    at, attributes = 8, {}
    while data[at] != 0:
        name_end = data.index(b"\0", at)
        kind_end = data.index(b"\0", name_end + 1)
        body_end = kind_end + 5 + struct.unpack("<i", data[kind_end + 1:kind_end + 5])[0]
        attributes[data[at:name_end].decode()] = data[name_end + 1:kind_end].decode(), data[kind_end + 5:body_end]
        at = body_end
    return attributes, at + 1

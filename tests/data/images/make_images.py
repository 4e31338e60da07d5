#!/usr/bin/env python3
"""Makes every firmware file of this folder again, byte for byte:

    python3 tests/data/images/make_images.py

The contents mean nothing to any chip; only their form matters.
"""

import pathlib
import struct

HERE = pathlib.Path(__file__).parent
# What firmware begins with (a GOTO), then bytes that are all different.
FIRMWARE = bytes([0x10, 0xEF, 0x00, 0xF0]) + bytes(range(4, 64))
# What a bitstream begins with: padding and the word an FPGA looks for.
BITSTREAM = b"\xff" * 4 + b"\xaa\x99\x55\x66" + bytes(range(8, 64))


def record(kind, address, data=b"", upper=True, checksum_error=0):
    body = bytes([len(data), address >> 8, address & 0xFF, kind]) + bytes(data)
    text = body.hex() + "%02x" % ((-sum(body) + checksum_error) & 0xFF)
    return ":" + (text.upper() if upper else text)


END = record(1, 0)


def data_records(data, start=0, size=16, upper=True):
    return [record(0, start + at, data[at:at + size], upper) for at in range(0, len(data), size)]


def lines(*records, end="\n"):
    return (end.join(records) + end).encode()


def field(key, text):
    return key + struct.pack(">H", len(text) + 1) + text + b"\0"


def bit(data, length=None, part=b"3s50avq100"):
    header = bytes.fromhex("00090ff00ff00ff00ff0000001")
    header += field(b"a", b"robot.ncd;UserID=0xFFFFFFFF") + field(b"b", part)
    header += field(b"c", b"2011/06/24") + field(b"d", b"12:04:03")
    return header + b"e" + struct.pack(">I", len(data) if length is None else length) + data


GOOD = {
    "firmware.hex": lines(*data_records(FIRMWARE), END),
    "firmware.bin": FIRMWARE,
    "lower-case-crlf.hex": lines(*data_records(FIRMWARE, upper=False), END.lower(), end="\r\n"),
    "gaps.hex": lines(record(0, 0, FIRMWARE[:8]), record(0, 0x40, b"\x40\x41"), record(0, 0x30, b"\x30"), END),
    "all-record-types.hex": lines(
        record(3, 0, b"\x00\x00\x01\x00"), record(0, 0, FIRMWARE[:4]), record(2, 0, b"\x01\x00"),
        record(0, 0x10, b"\x11\x12"), record(4, 0, b"\x00\x01"), record(0, 0x10, b"\x21\x22"),
        record(5, 0, b"\x00\x00\x00\x00"), END),
    "segment-wraps.hex": lines(record(2, 0, b"\x10\x00"), record(0, 0xFFFF, b"\x01\x02"), END),
    "no-last-line-end.hex": lines(*data_records(FIRMWARE), END).rstrip(),
    "configuration.hex": lines(
        *data_records(FIRMWARE), record(4, 0, b"\x00\x01"), record(0, 0xEFFF, b"\x5a\xa5"),
        record(0, 0xFFF8, bytes(range(1, 9))), END),
    "bitstream.bit": bit(BITSTREAM),
    "bitstream.bin": BITSTREAM,
}

FIRST = record(0, 0, FIRMWARE[:4])
MALFORMED = {
    "junk.hex": lines(FIRST, "this is no record", END),
    "junk-in-record.hex": lines(FIRST, ":0100040x00FB", END),
    "no-colon.hex": lines(FIRST, record(0, 4, b"\x04")[1:], END),
    "bad-checksum.hex": lines(FIRST, record(0, 4, b"\x04", checksum_error=1), END),
    "record-too-short.hex": lines(FIRST, record(0, 4, b"\x04\x05")[:-2], END),
    "record-too-long.hex": lines(FIRST, record(0, 4, b"\x04") + "00", END),
    "odd-digits.hex": lines(FIRST, record(0, 4, b"\x04")[:-1], END),
    "unknown-type.hex": lines(FIRST, record(6, 0, b"\x00"), END),
    "base-of-one-byte.hex": lines(FIRST, record(4, 0, b"\x01"), END),
    "end-with-data.hex": lines(FIRST, record(1, 0, b"\x00")),
    "overlap.hex": lines(FIRST, record(0, 8, b"\x08"), record(0, 3, b"\x03"), END),
    "overlap-across.hex": lines(record(0, 8, b"\x08"), record(0, 4, bytes(8)), END),
    "missing-end.hex": lines(FIRST),
    "after-end.hex": lines(FIRST, END, FIRST),
    "past-flash.hex": lines(FIRST, record(4, 0, b"\x00\x20"), record(0, 0, b"\x01"), END),
    "across-flash-end.hex": lines(FIRST, record(4, 0, b"\x00\x1f"), record(0, 0xFFFF, b"\x01\x02"), END),
    "no-data.hex": lines(END),
    "empty.bin": b"",
    "cut-off.bit": bit(BITSTREAM)[:-1],
    "too-much.bit": bit(BITSTREAM) + b"\0",
    "cut-in-header.bit": bit(BITSTREAM)[:40],
    "no-preamble.bit": bit(BITSTREAM)[1:],
    "control-character.bit": bit(BITSTREAM, part=b"3s50\x1bavq"),
    "no-bitstream.bit": bit(b""),
    "length-of-4-gigabytes.bit": bit(BITSTREAM, length=0xFFFFFFFF),
}

for folder, files in (("good", GOOD), ("malformed", MALFORMED)):
    (HERE / folder).mkdir(exist_ok=True)
    for name, contents in files.items():
        (HERE / folder / name).write_bytes(contents)

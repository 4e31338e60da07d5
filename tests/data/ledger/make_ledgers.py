#!/usr/bin/env python3
"""Makes every database of this folder again:

    python3 tests/data/ledger/make_ledgers.py
"""

import pathlib
import sqlite3

HERE = pathlib.Path(__file__).parent
APPLICATION = 1263752260
TABLE = """CREATE TABLE parameters (
 id INTEGER PRIMARY KEY, run INTEGER NOT NULL, time_ms INTEGER NOT NULL, source TEXT NOT NULL,
 robot INTEGER NOT NULL, block BLOB NOT NULL, microcontroller INTEGER, flash INTEGER,
 note TEXT NOT NULL DEFAULT '')"""
ROW = "INSERT INTO parameters (run, time_ms, source, robot, block, microcontroller, flash, note) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"
TIME = 1308917043000
BLOCK = bytes([0, 14, 15, 3, 120, 0])


def make(name, statements, application=APPLICATION, version=1, rows=()):
    path = HERE / name
    path.unlink(missing_ok=True)
    database = sqlite3.connect(path)
    database.execute("PRAGMA page_size = 1024")
    for statement in statements:
        database.execute(statement)
    for row in rows:
        database.execute(ROW, row)
    database.execute("PRAGMA application_id = %d" % application)
    database.execute("PRAGMA user_version = %d" % version)
    database.commit()
    database.close()
    return path


GOOD = (1, TIME, "usb:", 3, BLOCK, 0x1234, 0x5678, "the one with the new dribbler")
made = make("good.sqlite", [TABLE], rows=[GOOD, (1, TIME + 1, "usb:", 5, BLOCK, None, None, "")])
make("rows-that-make-no-sense.sqlite", [TABLE], rows=[
    GOOD,
    (1, TIME, "usb:", 256, BLOCK, None, None, ""),
    (1, TIME, "usb:", -1, BLOCK, None, None, ""),
    (1, -5, "usb:", 3, BLOCK, None, None, ""),
    (1, 1 << 62, "usb:", 3, BLOCK, None, None, ""),
    (1, TIME, "usb:", 3, "text", None, None, ""),
    (1, TIME, "usb:", 3, bytes(256), None, None, ""),
    (1, TIME, b"\x00", 3, BLOCK, None, None, ""),
    (1, TIME, "usb:", 3, BLOCK, 0x10000, 0, ""),
    (1, TIME, "usb:", 3, BLOCK, 0, "many", ""),
    (1, TIME, "usb:", 3, BLOCK, None, None, "x" * 5000),
])
make("newer.sqlite", [TABLE], version=2)
make("other-program.sqlite", ["CREATE TABLE songs (title TEXT)"], application=0, version=0)
make("other-columns.sqlite", ["CREATE TABLE parameters (id INTEGER PRIMARY KEY, text TEXT)"])
(HERE / "cut-off.sqlite").write_bytes(made.read_bytes()[:1500])
(HERE / "no-database.sqlite").write_text("This is no database.\n" * 20)

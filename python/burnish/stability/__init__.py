"""Where methods fail: each known weakness as a case that can be run again, with a figure that must not get worse.

A module holds the cases of one subject; `case.py` says what a case is, `tests/stability` holds them to their thresholds and
`burnish chart --stability` shows them.
"""

"""A dask farm: the frames of a shot file on whatever workers a scheduler has.

    dask-scheduler                               # one machine
    dask-worker tcp://HOST:8786 --nthreads 1     # the others, as many as there are cores to give
    python3 examples/farm/dask_farm.py tcp://HOST:8786 shot.json 1-200
"""

import sys

import burnish
from dask.distributed import Client

address, shot, frames = sys.argv[1:]
with Client(address) as client:
    report = burnish.sequence.run(shot, frames, client=client, bad_frames="skip", progress=lambda stage, done: print(f"{100 * done:.0f} %"))
print(report.summary())
report.raise_if_failed()

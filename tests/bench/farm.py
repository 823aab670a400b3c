"""What a farm gains: frames on dask workers of one thread each, on processes, and in one process; all bits are compared.

    python3 tests/bench/farm.py --frames 200 --workers 4

The frames are one frame of `burnish demo` under many names, so all cost the same. "speed-up" is against one process with one thread, "efficiency"
divides it by the cores that the workers can have at most; what is missing to 1 is light and tables, which every worker makes once, idle workers
at the end, and what workers cost one another in caches and memory. The demo's tables are many: ten materials. "cpu_overhead" is the processor
time beyond that of one process with one thread, as a share; unlike the others it means something on a machine that does other work, too.
"""

import argparse
import csv
import hashlib
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", ROOT / "build" / "release")).resolve()
sys.path.insert(0, str(BUILD / "python"))
os.environ["PYTHONPATH"] = str(BUILD / "python")  # of the workers

import burnish  # noqa: E402


def make_shot(folder, frames, width):
    """The demo's frame as a sequence."""
    size = ["--width", str(width), "--height", str(width * 9 // 16)]
    subprocess.run([BUILD / "bin" / "burnish", "demo", "-o", folder, *size], check=True, capture_output=True)
    for frame in range(1, frames + 1):
        os.link(folder / "shot.exr", folder / f"frame.{frame:04d}.exr")
    document = burnish.Shot(folder / "shot.json").document
    return burnish.Shot({**document, "aovs": str(folder / "frame.####.exr"), "output": {"file": str(folder / "out" / "out.####.exr")}})


def digest(shot):
    """Of all outputs, which are then removed."""
    folder = pathlib.Path(shot.output).parent
    total = hashlib.sha256(b"".join(hashlib.sha256(path.read_bytes()).digest() for path in sorted(folder.iterdir()))).hexdigest()
    shutil.rmtree(folder)
    return total


def cpu_seconds(client):
    """Of this process, of children that ended, and of dask workers."""
    own = sum(sum(resource.getrusage(who)[:2]) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own + (sum(client.run(time.process_time).values()) if client else 0)


def measured(way, shot, cores, client=None, **how):
    """One row of the table."""
    begin, cpu = time.perf_counter(), cpu_seconds(client)
    report = burnish.sequence.run(shot, client=client, **how)
    seconds = time.perf_counter() - begin
    report.raise_if_failed()
    return {"way": way, "frames": len(report.frames), "chunk": report.chunk, "seconds": seconds, "cpu": cpu_seconds(client) - cpu,
            "cores": cores, "bits": digest(shot)}


def start_cost(shot):
    """(seconds of light and tables, seconds of a frame) on one thread."""
    one, several = ({**shot.document, "threads": 1, "frames": f"1-{count}"} for count in (1, 4))
    seconds = []
    for document in (one, several):
        begin = time.perf_counter()
        burnish.run(document)
        seconds.append(time.perf_counter() - begin)
    digest(shot)
    frame = (seconds[1] - seconds[0]) / 3
    return seconds[0] - frame, frame


def rows(shot, workers, chunk, is_brief):
    """Every way to run the shot; of a brief run the first and the last."""
    from distributed import Client, LocalCluster

    cores = len(os.sched_getaffinity(0))
    yield measured("one process, one thread", shot.with_(threads=1), 1, chunk=len(shot.frames().numbers))
    if not is_brief:
        yield measured("one process, all cores", shot, cores, chunk=len(shot.frames().numbers))
        yield measured(f"{workers} processes", shot.with_(threads=1), min(workers, cores), processes=workers, chunk=chunk)
    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        yield measured(f"{workers} dask workers", shot, min(workers, cores), client=client, chunk=chunk)


def main():
    """Measure and print."""
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--frames", type=int, default=40)
    words.add_argument("--workers", type=int, default=4)
    words.add_argument("--width", type=int, default=1920, help="of a frame; 16:9")
    words.add_argument("--chunk", type=int, help="frames a task [by frames and workers]")
    words.add_argument("--brief", action="store_true", help="only one process and dask")
    options = words.parse_args()
    with tempfile.TemporaryDirectory(prefix="burnish-farm-") as folder:
        shot = make_shot(pathlib.Path(folder), options.frames, options.width)
        start, frame = start_cost(shot)
        print(f"# {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}; a frame takes {frame:.2f} s on one thread, light and tables "
              f"{start:.2f} s, as much as {start / frame:.1f} frames", flush=True)
        table, first = csv.writer(sys.stdout), None
        table.writerow(["way", "frames", "chunk", "seconds", "seconds_a_frame", "speed_up", "efficiency", "cpu_seconds", "cpu_overhead", "same_bits"])
        for row in rows(shot, options.workers, options.chunk, options.brief):
            first = first or row
            gain = first["seconds"] / row["seconds"]
            table.writerow([row["way"], row["frames"], row["chunk"], f"{row['seconds']:.1f}", f"{row['seconds'] / row['frames']:.3f}",
                            f"{gain:.2f}", f"{gain / row['cores']:.2f}", f"{row['cpu']:.1f}", f"{row['cpu'] / first['cpu'] - 1:.3f}",
                            row["bits"] == first["bits"]])
            sys.stdout.flush()


if __name__ == "__main__":
    main()

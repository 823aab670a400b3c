"""Sequences on a real dask farm on loopback: same bits as in one process, also when workers, wire or scheduler are lost on the way."""

import json
import signal
from concurrent.futures import ThreadPoolExecutor

import burnish
import pytest
import scenes
from burnish.sequence.dask_pool import DaskPool
from burnish.sequence.tasks import make_task, run_task

distributed = pytest.importorskip("distributed", reason="DASK MISSING: install python3-distributed")

from loopback_farm import LoopbackFarm, Wire, wait_for  # noqa: E402

FRAMES = list(range(1, 9))
SLOW = dict(estimator="reference", tolerance=0.02, max_samples=1 << 15)  # tenths of a second a frame


@pytest.fixture(scope="module")
def shot(tmp_path_factory):
    """Eight frames of a sphere that differ; nothing of them is written yet."""
    folder = tmp_path_factory.mktemp("shot")
    scenes.write_exr(folder / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    for frame in FRAMES:
        scenes.write_frame(folder / f"f.{frame:04d}.exr", scenes.sphere(40, 30, 0.7 + 0.03 * frame))
    return burnish.Shot(aovs=folder / "f.####.exr", env=folder / "sky.exr", up="z", materials="gold", camera=scenes.CAMERA_JSON, **SLOW)


@pytest.fixture(scope="module")
def undisturbed(shot, tmp_path_factory):
    """File name -> bytes of a run in one process."""
    folder = tmp_path_factory.mktemp("undisturbed")
    assert burnish.sequence.run(shot, output=folder / "o.####.exr").is_complete
    return files(folder)


@pytest.fixture(scope="module")
def farm(tmp_path_factory):
    farm = LoopbackFarm(tmp_path_factory.mktemp("farm"))
    farm.add_workers(2)
    yield farm
    farm.close()


@pytest.fixture
def client(farm):
    """Of a farm with two workers, whatever became of those before."""
    farm.workers = [worker for worker in farm.workers if worker.poll() is None]
    farm.add_workers(2 - len(farm.workers))
    with distributed.Client(farm.address, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=60)
        yield client


def files(folder):
    """Hidden ones too."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def once_begun(folder, action):
    """Do something as soon as a frame is done, while others are not; gives a future of how many there were."""
    def wait():
        wait_for(lambda: list(folder.glob("o.*.exr")))
        action()
        return len(list(folder.glob("o.*.exr")))

    return ThreadPoolExecutor(1).submit(wait)


def test_the_farm_gives_the_same_bits(client, shot, undisturbed, tmp_path):
    told = []
    report = burnish.sequence.run(shot, client=client, chunk=3, progress=lambda stage, done: told.append(done), output=tmp_path / "o.####.exr")
    assert report.is_complete and report.workers == 2 and report.of("done") == FRAMES and not any(each.tries > 1 for each in report.frames)
    assert files(tmp_path) == undisturbed
    assert told == sorted(told) and told[-1] == 1 and any(0 < done < 1 for done in told)
    again = burnish.sequence.run(shot, client=client, output=tmp_path / "o.####.exr")
    assert again.of("skipped") == FRAMES

    def kept():
        from burnish.sequence.tasks import KEPT

        return len(KEPT.idle)

    wait_for(lambda: set(client.run(kept).values()) == {0})


def test_a_killed_workers_frames_go_elsewhere(client, farm, shot, undisturbed, tmp_path):
    killing = once_begun(tmp_path, lambda: farm.workers[0].send_signal(signal.SIGKILL))
    report = burnish.sequence.run(shot, client=client, chunk=2, output=tmp_path / "o.####.exr")
    assert killing.result() < len(FRAMES)
    assert farm.workers[0].wait() == -signal.SIGKILL and len(client.nthreads()) == 1
    assert report.is_complete and files(tmp_path) == undisturbed


def test_a_wire_that_is_cut_is_mended(client, farm, shot, undisturbed, tmp_path):
    wire, cuts = Wire(farm.address), []
    with distributed.Client(wire.address, set_as_default=False) as far:
        cutting = once_begun(tmp_path, lambda: cuts.append(wire.cut()))
        report = burnish.sequence.run(shot, client=far, chunk=1, output=tmp_path / "o.####.exr")
        assert cutting.result() < len(FRAMES)
    wire.close()
    assert cuts and cuts[0] > 0
    assert report.is_complete and files(tmp_path) == undisturbed


def test_after_the_scheduler_died_the_same_call_goes_on(shot, undisturbed, tmp_path):
    out, farms = tmp_path / "out", [LoopbackFarm(tmp_path)]
    out.mkdir()
    farms[0].add_workers(1)
    with distributed.Client(farms[0].address, timeout=1, set_as_default=False) as client:
        killing = once_begun(out, farms[0].close)
        with pytest.raises(burnish.LostConnection, match="goes on"):
            burnish.sequence.run(shot, client=client, chunk=1, output=out / "o.####.exr")
        killing.result()
    before = {path: path.stat().st_mtime_ns for path in out.iterdir()}
    assert 0 < len(before) < len(FRAMES) and all(undisturbed[path.name] == path.read_bytes() for path in before)
    report = burnish.sequence.run(shot, output=out / "o.####.exr")
    assert len(report.of("skipped")) == len(before) and report.is_complete and files(out) == undisturbed
    assert all(path.stat().st_mtime_ns == time for path, time in before.items())


def test_what_is_wrong_with_the_job_is_raised_once(client, shot, tmp_path):
    with pytest.raises(burnish.BadArgument, match="godl"):
        burnish.sequence.run(shot, client=client, chunk=1, material="godl", output=tmp_path / "o.####.exr")
    with pytest.raises(burnish.Cancelled, match="of 8 frames"):
        burnish.sequence.run(shot, client=client, progress=lambda stage, done: False, output=tmp_path / "o.####.exr")
    with pytest.raises(burnish.BadArgument, match="processes"):
        burnish.sequence.run(shot, client=client, processes=2)


def test_tasks_are_small_and_plain(shot):
    task = make_task(shot.document, FRAMES, None)
    assert json.loads(json.dumps(task)) == task and len(json.dumps(task)) < 4096
    with pytest.raises(burnish.BadArgument, match="install the same"):
        run_task({**task, "burnish": "0.0.0"})


def test_a_task_has_the_threads_of_its_worker(client):
    def threads():
        from burnish.sequence.tasks import _slots_of_worker

        return _slots_of_worker()

    assert client.submit(threads, pure=False).result() == 1 and threads() == 0


def test_a_farm_that_is_gone_is_told(farm):
    client = distributed.Client(farm.address, set_as_default=False)
    pool = DaskPool(client)
    client.close()
    with pytest.raises(burnish.LostConnection):
        pool.wait(None)


def test_the_command_line_goes_to_the_scheduler(client, farm, shot, undisturbed, cli, tmp_path):
    shot.write(tmp_path / "shot.json")
    out = tmp_path / "out"
    result = cli("sequence", tmp_path / "shot.json", "--scheduler", farm.address, "--frames", "1-3", "-o", out / "o.####.exr", "--json")
    assert result.code == 0 and json.loads(result.out)["done"] == 3
    assert files(out).items() <= undisturbed.items() and len(files(out)) == 3

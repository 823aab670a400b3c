"""Measured reflectance from Python and the command line: tables read, evaluated, written, told apart and shown."""

import hashlib
import json

import numpy as np
import pytest
import scenes

import burnish

HEADER = "# burnish gonio 1\n# surface isotropic\n# values brdf\n# columns theta_i phi_i theta_o phi_o R G B\n"
CELLS = 90 * 90 * 180


def glossy(theta_i, theta_o, phi):
    """A dark varnish: 0.1 everywhere and a highlight about the mirror direction."""
    off = np.hypot(theta_o * np.cos(np.radians(phi)) + theta_i, theta_o * np.sin(np.radians(phi)))
    return 0.1 + 2 * np.exp(-((off / 15) ** 2))


@pytest.fixture(scope="module")
def gonio(tmp_path_factory):
    """A goniometer's text of the varnish."""
    rows = [f"{i} 0 {o} {p} {(f := glossy(i, o, p)):.6g} {0.8 * f:.6g} {0.6 * f:.6g}"
            for i in range(0, 80, 10) for o in range(0, 85, 5) for p in range(0, 360, 15)]
    file = tmp_path_factory.mktemp("gonio") / "varnish.gonio"
    file.write_text(HEADER + "\n".join(rows) + "\n")
    return file


@pytest.fixture(scope="module")
def merl(tmp_path_factory):
    """The bytes of a MERL table that is 0.133, 0.153 and 0.221 everywhere."""
    file = tmp_path_factory.mktemp("merl") / "flat.binary"
    file.write_bytes(np.array([90, 90, 180], "<i4").tobytes() + np.full(3 * CELLS, 200.0).tobytes())
    return file


def directions(*angles_deg):
    theta, phi = np.radians(np.array(angles_deg, float)).T
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], 1)


def test_a_goniometers_text(gonio):
    measured = burnish.read_measured(gonio)
    wo, wi, f = measured.samples()
    assert wo.shape == wi.shape == f.shape and len(f) == 8 * 17 * 24
    assert np.allclose(measured.eval(wo, wi), f, rtol=1e-4)
    assert measured.is_isotropic and not measured.transmits
    mirrored = measured.eval(directions([35, 180]), directions([35, 0]))
    assert mirrored[0, 0] == pytest.approx(2.1, rel=0.05)


def test_a_merl_table_keeps_its_bytes(merl, tmp_path):
    measured = burnish.read_measured(merl)
    measured.write_merl(tmp_path / "again.binary")
    assert hashlib.sha256((tmp_path / "again.binary").read_bytes()).digest() == hashlib.sha256(merl.read_bytes()).digest()
    assert measured.eval(directions([20, 0]), directions([60, 100])) == pytest.approx(np.array([[200, 230, 332]]) / 1500, rel=1e-5)


def test_any_isotropic_measurement_becomes_a_merl_table(gonio, tmp_path):
    source = burnish.read_measured(gonio)
    source.write_merl(tmp_path / "varnish.binary")
    table = burnish.read_measured(tmp_path / "varnish.binary")
    wo, wi = directions([30, 180], [20, 90]), directions([35, 0], [50, 0])
    assert table.eval(wo, wi) == pytest.approx(source.eval(wo, wi), rel=0.05)


def test_what_a_file_holds(gonio, merl):
    about = burnish.read_measured(merl).info()
    assert about["samples"] == CELLS and about["merl_name"] == ""
    assert about["kd"] == pytest.approx(np.array([200, 230, 332]) / 1500 * np.pi, rel=0.01)
    about = burnish.read_measured(gonio).info()
    assert about["theta_i_deg"] == [0, 70]
    assert about["kd"][0] == pytest.approx(0.1 * np.pi, rel=0.02)


def test_info_tells_of_measurements(cli, gonio):
    text = cli("info", gonio)
    assert text.code == 0 and "3264 valid, incident angles from 0 to 70 degrees" in text.out
    assert json.loads(cli("info", gonio, "--json").out)["isotropic"] is True


def test_a_measurement_is_a_lobe(gonio):
    lobe = burnish.Lobe({"model": "table", "table": str(gonio)})
    measured = burnish.read_measured(gonio)
    wo, wi = directions([30, 0]), directions([33, 170])
    assert lobe.eval(wo, wi)[0] + np.array(measured.info()["kd"]) / np.pi == pytest.approx(measured.eval(wo, wi)[0], rel=1e-2)


@pytest.fixture
def frame(tmp_path):
    """A folder with a frame and a light."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    return tmp_path


def overlay(frame, material, **settings):
    return burnish.composite(frame / "beauty.exr", frame / "sky.exr", str(material), **settings)["overlay"]


def test_all_estimators_show_a_measurement(frame, gonio):
    exact = overlay(frame, gonio, estimator="reference", tolerance=0.01)
    assert exact.max() > 0
    for estimator in ("fitted", "regular", "filtered_importance", "preconvolved", "split_sum"):
        found = overlay(frame, gonio, estimator=estimator, density="dense")
        assert burnish.compare(found, exact)["psnr_db"] > 30, estimator


def test_threads_do_not_matter(frame, gonio):
    assert np.array_equal(overlay(frame, gonio, threads=1), overlay(frame, gonio, threads=2))


def test_a_shot_names_tables_from_its_folder(cli, frame, gonio, tmp_path_factory):
    (frame / "varnish.gonio").write_bytes(gonio.read_bytes())
    shot = {"aovs": "beauty.exr", "lights": {"sky": {"file": "sky.exr"}}, "output": {"file": "out.exr"}, "material": "varnish",
            "materials": {"varnish": {"model": "table", "table": "varnish.gonio"}}}
    (frame / "shot.json").write_text(json.dumps(shot))
    result = cli("composite", frame / "shot.json", cwd=tmp_path_factory.mktemp("elsewhere"))
    assert result.code == 0, result.err
    assert (frame / "out.exr").exists()

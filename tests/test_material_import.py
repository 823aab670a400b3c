"""Materials of glTF and MaterialX files against their specifications' equations, in any state a file may be in."""

import json
import struct

import burnish
import numpy as np
import pytest
import scenes


def gltf(*materials, **fields):
    return json.dumps({"asset": {"version": "2.0"}, "materials": list(materials), **fields})


def mtlx(kind, inputs="", name="M", version=""):
    """A MaterialX document of one material; `inputs`: "base=0.5 metalness=1"."""
    nodes = "".join(f'<input name="{key}" type="any" value="{value}"/>' for key, value in (word.split("=") for word in inputs.split()))
    return (f'<materialx version="1.38"><{kind} name="SR" type="surfaceshader" {version}>{nodes}</{kind}>'
            f'<surfacematerial name="{name}" type="material"><input name="surfaceshader" type="surfaceshader" nodename="SR"/>'
            "</surfacematerial></materialx>")


@pytest.fixture
def read(tmp_path):
    """The materials of a text: name -> {"kd", "lobes", "notes"}."""

    def run(text, suffix=None):
        file = tmp_path / ("m" + (suffix or (".mtlx" if text.startswith("<") else ".gltf")))
        file.write_text(text) if isinstance(text, str) else file.write_bytes(text)
        return {entry["name"]: {**entry["material"], "notes": entry["notes"]} for entry in burnish.read_materials(file)}

    return run


def colour(value):
    return np.broadcast_to(np.asarray(value, float), 3)


def reflectance(material, cosine):
    """F of all reflecting lobes together at one microfacet, strengths and tints included."""
    total = np.zeros(3)
    for lobe in material["lobes"]:
        if "ks" in lobe:
            assert set(lobe) & {"ior", "eta"} == set() and colour(lobe.get("f1", 0)).max() == 0
            r0 = colour(lobe["r0"])
            total += lobe["ks"] * colour(lobe["tint"]) * (r0 + (1 - r0) * (1 - cosine) ** 5)
    return total


def schlick(f0, f90, cosine):
    return colour(f0) + (colour(f90) - colour(f0)) * (1 - cosine) ** 5


COSINES = (1.0, 0.7, 0.3, 0.0)


@pytest.mark.parametrize("ior", [1.0, 1.33, 1.5, 2.4])
def test_f0_follows_from_the_index(read, ior):
    f0 = ((ior - 1) / (ior + 1)) ** 2
    for text in (gltf({"pbrMetallicRoughness": {"metallicFactor": 0}, "extensions": {"KHR_materials_ior": {"ior": ior}}}),
                 mtlx("standard_surface", f"specular_IOR={ior}"), mtlx("open_pbr_surface", f"specular_ior={ior}")):
        (material,) = read(text).values()
        assert np.allclose(reflectance(material, 1), f0, atol=1e-6)


def test_gltf_by_its_equations(read):
    """Appendix B of glTF 2.0 and KHR_materials_specular: dielectric and metal mixed."""
    base, metallic, specular, tint = np.array([0.8, 0.4, 0.1]), 0.3, 0.6, np.array([1.0, 0.5, 0.25])
    (material,) = read(gltf({
        "name": "a", "pbrMetallicRoughness": {"baseColorFactor": [*base, 1], "metallicFactor": metallic, "roughnessFactor": 0.4},
        "extensions": {"KHR_materials_specular": {"specularFactor": specular, "specularColorFactor": list(tint)}}})).values()
    for c in COSINES:
        expected = (1 - metallic) * schlick(0.04 * tint * specular, specular, c) + metallic * schlick(base, 1, c)
        assert np.allclose(reflectance(material, c), expected, atol=1e-5)
    assert np.allclose(material["kd"], base * (1 - metallic), atol=1e-6) and material["kd_coupled"]
    assert all(lobe["mx"] == lobe["my"] == pytest.approx(0.16) for lobe in material["lobes"])


@pytest.mark.parametrize("text, widths, degrees", [
    (gltf({"pbrMetallicRoughness": {"roughnessFactor": 0.5},
           "extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 0.6, "anisotropyRotation": np.pi / 6}}}),
     (0.25 + 0.75 * 0.36, 0.25), 30),
    (mtlx("standard_surface", "metalness=1 specular_roughness=0.4 specular_anisotropy=0.75 specular_rotation=0.25"), (0.32, 0.08), 90),
    (mtlx("open_pbr_surface", "base_metalness=1 specular_roughness=0.4 specular_roughness_anisotropy=0.5"),
     (0.16 * np.sqrt(1.6), 0.08 * np.sqrt(1.6)), 0)], ids=["gltf", "standard_surface", "open_pbr_surface"])
def test_widths_are_those_of_each_model(read, text, widths, degrees):
    (material,) = read(text).values()
    (lobe,) = material["lobes"]
    assert (lobe["mx"], lobe["my"]) == pytest.approx(widths, rel=1e-5)
    assert lobe.get("rotation_deg", 0) == pytest.approx(degrees, abs=1e-4)


def test_metals_have_no_diffuse_part(read):
    for text in (gltf({"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.6, 0.2, 1]}}),
                 mtlx("standard_surface", "base=1 base_color=0.9,0.6,0.2 metalness=1"),
                 mtlx("open_pbr_surface", "base_color=0.9,0.6,0.2 base_metalness=1")):
        (material,) = read(text).values()
        assert material["kd"] == 0
        assert np.allclose(reflectance(material, 1), [0.9, 0.6, 0.2]) and np.allclose(reflectance(material, 0), 1)


def test_a_coat_takes_what_it_reflects_from_below(read):
    (material,) = read(mtlx("standard_surface", "base=1 base_color=0.9,0.6,0.2 metalness=1 coat=0.5 coat_roughness=0.2")).values()
    base, coat = material["lobes"]
    assert (coat["ks"], coat["r0"], coat["mx"]) == pytest.approx((0.5, 0.04, 0.04))
    assert np.allclose(reflectance({"lobes": [base]}, 1), np.array([0.9, 0.6, 0.2]) * 0.98)
    assert np.allclose(reflectance(material, 0), 1)
    (whole,) = read(mtlx("open_pbr_surface", "base_color=0.9,0.6,0.2 base_metalness=1 coat_weight=1 coat_roughness=0.2")).values()
    f0 = (0.6 / 2.6) ** 2
    assert np.allclose(reflectance(whole, 1), f0 + (1 - f0) * np.array([0.9, 0.6, 0.2]), atol=1e-5)


def test_glass_lets_through_what_it_does_not_reflect(read):
    (material,) = read(gltf({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.3, "baseColorFactor": [0.5, 1, 1, 1]},
                             "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}})).values()
    through = [lobe for lobe in material["lobes"] if "kt" in lobe]
    assert [(lobe["kt"], lobe["tint"], lobe["mx"]) for lobe in through] == [(1, [0.5, 1, 1], pytest.approx(0.09))]
    assert material["kd"] == 0


def furnace(metalness, coat, transmission, roughness):
    return mtlx("standard_surface", f"base=1 base_color=1,1,1 metalness={metalness} coat={coat} transmission={transmission} specular_roughness={roughness}")


@pytest.mark.parametrize("numbers", [(0, 0, 0, 0.1), (1, 0, 0, 0.3), (0.5, 0, 0, 0.6), (0, 0, 1, 0.3), (0.3, 0, 0.5, 1)])
def test_no_material_makes_energy(tmp_path, numbers):
    (tmp_path / "m.mtlx").write_text(furnace(*numbers))
    assert burnish.check_energy(str(tmp_path / "m.mtlx"))["max_albedo"] <= 1.005


@pytest.mark.parametrize("numbers", [(1, 1, 0, 0.2), (1, 1, 0, 0.6), (0.5, 0.5, 0, 0.6), (0, 1, 0, 0.2), (0, 0.5, 1, 0.3)])
def test_a_coat_makes_no_energy_but_at_grazing_views(read, numbers):
    """Below a coat that is smoother than they are, lobes see another angle than it does; beyond 75 degrees that tells (1.4 at 85)."""
    (material,) = read(furnace(*numbers)).values()
    for degrees in (0, 45, 60, 70, 75):
        wo = np.array([[np.sin(np.radians(degrees)), 0, np.cos(np.radians(degrees))]], np.float32)
        assert sum(burnish.Lobe(lobe).albedo(wo)[0, 1] for lobe in material["lobes"]) <= 1.005


def test_defaults_are_those_of_each_version(read):
    for version, kd in (('version="1.0.0"', 0.4), ("", 0.5)):
        (material,) = read(mtlx("standard_surface", "base_color=0.5,0.5,0.5", version=version)).values()
        assert material["kd"] == pytest.approx(kd)
    (material,) = read(mtlx("standard_surface")).values()
    assert material["kd"] == pytest.approx(0.8) and material["lobes"][0]["mx"] == pytest.approx(0.04)
    (material,) = read(gltf({})).values()
    assert material["lobes"][0]["mx"] == 1 and np.allclose(reflectance(material, 1), 1)


def test_srgb_colours_become_light(read):
    text = mtlx("standard_surface", "base=1 base_color=0.5,0.5,0.5").replace('version="1.38"', 'version="1.38" colorspace="srgb_texture"')
    (material,) = read(text).values()
    assert material["kd"] == pytest.approx(0.21404, rel=1e-4)


def test_what_is_left_out_is_told(read):
    (material,) = read(gltf({"name": "a", "normalTexture": {"index": 0}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                             "extensions": {"KHR_materials_sheen": {}}})).values()
    assert [note.split(": ", 1)[1].split(" is left")[0] for note in material["notes"]] == [
        "materials[0].normalTexture", "materials[0].extensions.KHR_materials_sheen", "materials[0].pbrMetallicRoughness.baseColorTexture"]
    text = mtlx("standard_surface", "sheen=0.5").replace("</standard_surface>", '<input name="base_color" nodegraph="g"/></standard_surface>')
    (material,) = read(text).values()
    assert len(material["notes"]) == 2 and "SR.base_color comes from a texture" in material["notes"][0] and "SR.sheen" in material["notes"][1]


def glb(text):
    body = text.encode() + b" " * (-len(text) % 4)
    return struct.pack("<4sIII4s", b"glTF", 2, 20 + len(body), len(body), b"JSON") + body


def test_one_of_several_is_chosen_by_name(cli, read, tmp_path):
    names = list(read(glb(gltf({"name": "paint"}, {}, {"name": "glass é"})), ".glb"))
    assert names == ["paint", "material_1", "glass é"]
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    words = ["composite", "beauty.exr", "--env", "sky.exr", "-o", "out.exr", "--material"]
    assert cli(*words, "m.glb#glass é", cwd=tmp_path).code == 0
    for name, parts in (("m.glb", ["3 materials", "m.glb#paint"]), ("m.glb#pant", ['did you mean "paint"', "material_1"])):
        with pytest.raises(burnish.BadArgument) as told:
            burnish.check_energy(str(tmp_path / name))
        assert all(part in str(told.value) for part in parts)
    listed = cli("models", "m.glb", cwd=tmp_path)
    assert [line for line in listed.out.splitlines() if line.startswith("m.glb#")] == [f"m.glb#{name}" for name in names]


def test_a_composite_of_an_imported_metal_is_that_of_its_numbers(cli, tmp_path):
    """Roundtrip, in a shot file that lies elsewhere."""
    (tmp_path / "shots").mkdir()
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    (tmp_path / "car.gltf").write_text(gltf({"name": "brass", "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.7, 0.3, 1], "roughnessFactor": 0.5,
                                                                                  "metallicRoughnessTexture": {"index": 0}}}))
    by_hand = {"model": "ggx", "m": 0.25, "r0": [0.9, 0.7, 0.3], "kd": 0}
    for name, material in (("imported", "../car.gltf#brass"), ("by_hand", by_hand)):
        shot = {"aovs": "../beauty.exr", "lights": {"sky": {"file": "../sky.exr"}}, "materials": {"metal": material}, "material": "metal",
                "output": {"file": f"{name}.exr"}}
        (tmp_path / "shots" / f"{name}.json").write_text(json.dumps(shot))
        result = cli("composite", tmp_path / "shots" / f"{name}.json")
        assert result.code == 0 and ("metallicRoughnessTexture is left out" in result.err) == (name == "imported"), result.err
    a, b = (scenes.read_exr(tmp_path / "shots" / f"{name}.exr") for name in ("imported", "by_hand"))
    assert all(np.allclose(a[name], b[name], rtol=1e-3, atol=1e-4) for name in a) and a["burnish_spec.R"].max() > 0.1


@pytest.mark.parametrize("suffix, content, code, part", [
    (".gltf", gltf({"pbrMetallicRoughness": {"roughnessFactor": 1.5}}), "E_BAD_ARGUMENT", "materials[0].pbrMetallicRoughness.roughnessFactor"),
    (".gltf", gltf({"pbrMetallicRoughness": {"baseColorFactor": [1, 1]}}), "E_BAD_ARGUMENT", "baseColorFactor"),
    (".gltf", gltf({"pbrMetallicRoughness": 3}), "E_BAD_ARGUMENT", "materials[0].pbrMetallicRoughness"),
    (".gltf", gltf({}, {"extensions": {"KHR_materials_ior": {"ior": "x"}}}), "E_BAD_ARGUMENT", "materials[1].extensions.KHR_materials_ior.ior"),
    (".gltf", gltf(7), "E_BAD_ARGUMENT", "materials[0]"),
    (".gltf", json.dumps({"asset": {"version": "2.0"}, "materials": 3}), "E_BAD_ARGUMENT", "materials"),
    (".gltf", json.dumps({"asset": {"version": "1.0"}}), "E_READ_FAILED", "glTF 2.0"),
    (".gltf", gltf(), "E_READ_FAILED", "found none"),
    (".gltf", "[" * 100000, "E_READ_FAILED", "64 levels"),
    (".gltf", "", "E_READ_FAILED", "not valid JSON"),
    (".glb", b"glTF\2\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON", "E_READ_FAILED", "cut short"),
    (".glb", b"glTF", "E_READ_FAILED", ""),
    (".mtlx", "", "E_READ_FAILED", "XML"),
    (".mtlx", "<materialx", "E_READ_FAILED", "XML"),
    (".mtlx", "<a>" * 200000, "E_READ_FAILED", "XML"),
    (".mtlx", "<x/>", "E_READ_FAILED", "<materialx>"),
    (".mtlx", "<materialx/>", "E_READ_FAILED", "found none"),
    (".mtlx", mtlx("UsdPreviewSurface"), "E_READ_FAILED", "UsdPreviewSurface"),
    (".mtlx", mtlx("standard_surface").replace('nodename="SR"', 'nodename="no"'), "E_READ_FAILED", "'no'"),
    (".mtlx", mtlx("standard_surface", "base_color=1,2"), "E_BAD_ARGUMENT", "SR.base_color"),
    (".mtlx", mtlx("standard_surface", "metalness=nan"), "E_BAD_ARGUMENT", "SR.metalness"),
    (".mtlx", mtlx("standard_surface", "metalness=2"), "E_BAD_ARGUMENT", "between 0 and 1"),
], ids=range(22))
def test_files_that_are_not_what_they_should_be(tmp_path, suffix, content, code, part):
    file = tmp_path / f"m{suffix}"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(burnish.Error) as told:
        burnish.read_materials(file)
    assert told.value.code == code and f"m{suffix}" in str(told.value) and part in str(told.value), told.value


@pytest.mark.parametrize("suffix", [".gltf", ".glb", ".mtlx"])
def test_a_file_that_is_not_there(tmp_path, suffix):
    with pytest.raises(burnish.ReadFailed, match="absent"):
        burnish.read_materials(tmp_path / f"absent{suffix}")


def test_damaged_bytes_never_crash(tmp_path):
    """Every file cut off somewhere, and with a byte changed, is read or refused."""
    rng = np.random.default_rng(3)
    texts = {".glb": glb(gltf({"name": "a", "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.7, 0.3, 1]}}, {"extensions": {"KHR_materials_ior": {"ior": 1.4}}})),
             ".mtlx": mtlx("standard_surface", "base_color=0.1,0.2,0.3 coat=0.4").encode()}
    for suffix, whole in texts.items():
        for _ in range(400):
            damaged = bytearray(whole[: rng.integers(1, len(whole) + 1)])
            damaged[rng.integers(len(damaged))] = rng.integers(256)
            (tmp_path / f"m{suffix}").write_bytes(damaged)
            try:
                assert burnish.read_materials(tmp_path / f"m{suffix}")
            except burnish.Error as error:
                assert "m" + suffix in str(error) and error.code in ("E_READ_FAILED", "E_BAD_ARGUMENT")

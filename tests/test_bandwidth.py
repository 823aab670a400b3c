"""Local bandwidth by wavelets against windowed Fourier transforms: 32 x 32, Hann, 95th percentile of the energy without the mean.

A window tells what is somewhere in it, a wavelet what is at a pixel: predictions are the largest of nine by nine pixels at the
window's middle. Frequencies below two cycles a window, which it cannot tell apart, count as that. Run with -s for the figures.
"""

import burnish
import numpy as np
import pytest

WINDOW, STEP, REACH = 32, 4, 4
LEAST = 2 / WINDOW
SIZE = 256
REAL = ["dikhololo_night", "lebombo", "rooitou_park", "st_fagans_interior", "studio_small_03"]


def fourier_bandwidth(image):
    """The frequency below which 95 % of each window's energy lies; NaN where a window is flat."""
    hann = np.hanning(WINDOW + 1)[:-1]
    window = np.outer(hann, hann)
    frequency = np.hypot(*np.meshgrid(np.fft.fftfreq(WINDOW), np.fft.fftfreq(WINDOW))).ravel()
    order = np.argsort(frequency)
    patches = np.lib.stride_tricks.sliding_window_view(image, (WINDOW, WINDOW))[::STEP, ::STEP]
    mean = (patches * window).sum((2, 3), keepdims=True) / window.sum()
    energy = np.abs(np.fft.fft2((patches - mean) * window)) ** 2
    share = energy.reshape(*mean.shape[:2], -1)[..., order].cumsum(-1)
    flat = share[..., -1] < 1e-6 * (window.sum() * mean[..., 0, 0]) ** 2
    found = frequency[order][np.argmax(share >= 0.95 * share[..., -1:], axis=-1)]
    return np.where(flat, np.nan, found)


def at_windows(nu):
    """The largest value near the middle of each of those windows."""
    width = 2 * REACH + 1
    largest = np.lib.stride_tricks.sliding_window_view(nu, (width, width)).max((2, 3))
    first = WINDOW // 2 - REACH
    count = (np.array(nu.shape) - WINDOW) // STEP + 1
    return largest[first:, first:][::STEP, ::STEP][: count[0], : count[1]]


def ranks(values):
    return np.argsort(np.argsort(values))


def compared(image, rule="energy"):
    """Rank correlation, shares predicted more than an octave too low and too high, and the median in octaves."""
    expected = fourier_bandwidth(image)
    found = at_windows(burnish.local_bandwidth(image, rule, surround="repeat"))
    inside = np.isfinite(expected)
    expected, found = expected[inside], found[inside]
    octaves = np.log2(np.maximum(found, LEAST) / np.maximum(expected, LEAST))
    correlation = np.corrcoef(ranks(found), ranks(expected))[0, 1]
    return {"rank": correlation, "low": np.mean(octaves < -1), "high": np.mean(octaves > 1), "median": np.median(octaves)}


def told(name, figures):
    print(f"{name:24}", *(f"{key} {value:5.2f}" for key, value in figures.items()))
    return figures


def filtered_noise(response):
    """White noise times response(frequency), on a mean of 1."""
    noise = np.fft.fft2(np.random.default_rng(1).normal(size=(SIZE, SIZE)))
    frequency = np.hypot(*np.meshgrid(np.fft.fftfreq(SIZE), np.fft.fftfreq(SIZE)))
    frequency[0, 0] = 1 / SIZE
    image = np.real(np.fft.ifft2(noise * response(frequency)))
    return 1 + 0.1 * image / image.std()


X, Y = np.meshgrid(np.arange(SIZE), np.arange(SIZE))
SYNTHETIC = {
    "white noise": filtered_noise(lambda f: 1),
    "noise 1/f": filtered_noise(lambda f: 1 / f),
    "noise below 0.1": filtered_noise(lambda f: f < 0.1),
    "noise below 0.2": filtered_noise(lambda f: f < 0.2),
    "noise below 0.35": filtered_noise(lambda f: f < 0.35),
    "Gaussian noise 0.06": filtered_noise(lambda f: np.exp(-((f / 0.06) ** 2) / 2)),
    "Gaussian noise 0.12": filtered_noise(lambda f: np.exp(-((f / 0.12) ** 2) / 2)),
    "wave 0.1": 1 + 0.5 * np.sin(0.2 * np.pi * (0.8 * X + 0.6 * Y)),
    "wave 0.3": 1 + 0.5 * np.sin(0.6 * np.pi * (0.8 * X + 0.6 * Y)),
    "checkers": 1 + (X // 16 + Y // 16) % 2,
}


@pytest.mark.parametrize("name", SYNTHETIC)
def test_it_agrees_with_fourier_transforms(name):
    figures = told(name, compared(SYNTHETIC[name]))
    assert abs(figures["median"]) < 0.6
    assert figures["low"] < 0.01 and figures["high"] < 0.25


def test_it_ranks_a_chirp():
    figures = told("chirp", compared(1 + np.sin(np.pi * 0.45 * X**2 / SIZE)))
    assert figures["rank"] > 0.9 and figures["low"] == 0


def latlong(environment, height=SIZE):
    v, u = (np.mgrid[0:height, 0 : 2 * height] + 0.5) / height
    phi, theta = np.pi * (1 - u), np.pi * v
    d = np.stack([np.sin(phi) * np.sin(theta), np.cos(theta), np.cos(phi) * np.sin(theta)], -1)
    return (environment.radiance(d.reshape(-1, 3)) @ [0.2126, 0.7152, 0.0722]).reshape(height, 2 * height)


@pytest.mark.parametrize("name", REAL)
def test_it_is_rarely_low_on_real_light(name, data):
    picture = latlong(burnish.Environment(str(data(f"public/env/{name}_1k.hdr"))))
    energy, maxima = (told(f"{name} {rule}", compared(picture, rule)) for rule in ("energy", "maxima"))
    assert energy["low"] < 0.35 and energy["high"] < 0.35 and abs(energy["median"]) < 0.5
    assert energy["rank"] > maxima["rank"]


def test_light_from_all_sides_has_a_bound_everywhere():
    sky = np.full((128, 256, 3), 0.5, np.float32)
    sky[60:64, 100:104] = 30
    light = burnish.LightBandwidth(burnish.Environment(sky, env_convention="openexr", env_suns="keep"))
    phi, theta = np.pi * (1 - 2 * 102 / 256), np.pi * 62 / 128
    lamp = np.array([np.sin(phi) * np.sin(theta), np.cos(theta), np.cos(phi) * np.sin(theta)])
    away = np.array([-lamp[0], lamp[1], -lamp[2]])
    nearby = lamp + 0.2 * np.cross(lamp, [0, 1, 0])
    at_lamp, at_nearby, at_away = light.at([lamp, nearby, away], 0.0)
    assert at_lamp > 5 and at_nearby < 0.5 * at_lamp and at_away < 0.01
    assert light.at([nearby], 0.3)[0] >= at_lamp
    with pytest.raises(burnish.SizeMismatch):
        light.at([1.0, 2.0], 0.0)


@pytest.mark.parametrize("model", ["beckmann", "ggx", "kurt"])
def test_sharp_lobes_let_more_through(model):
    sharp, wide = (burnish.LobeBandwidth(burnish.Lobe({"model": model, "mx": m, "my": m})) for m in (0.01, 0.1))
    cos_o = np.cos(np.radians([0, 30, 60]))
    assert np.allclose(sharp.nu_rho(cos_o) / wide.nu_rho(cos_o), 10, rtol=0.1)
    wo, mirror = [[0.6, 0, 0.8]], [[-0.6, 0, 0.8]]
    assert sharp.at(wo, mirror)[0] > 5 * wide.at(wo, mirror)[0]


@pytest.mark.parametrize("change, error, part", [
    (dict(image=np.zeros((4, 4, 3))), burnish.SizeMismatch, "one channel"),
    (dict(image=np.zeros(4)), burnish.SizeMismatch, "image"),
    (dict(rule="quantile"), burnish.BadArgument, "energy, maxima"),
    (dict(surround="mirror"), burnish.BadArgument, "zero, repeat, latlong"),
    (dict(quantile=1.5), burnish.BadArgument, "quantile"),
    (dict(epsilon=0), burnish.BadArgument, "epsilon"),
])
def test_what_cannot_be_used_is_named(change, error, part):
    with pytest.raises(error, match=part):
        burnish.local_bandwidth(**{"image": np.zeros((8, 8)), **change})

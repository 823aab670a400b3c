"""Every public sample file is processed or refused with one clear line, and docs/sample_files.md says which and why."""

import resource
import sys

import pytest
from conftest import DATA, SOURCE

sys.path.insert(0, str(SOURCE / "tests" / "bench"))

import sample_files  # noqa: E402

FILES = sample_files.sample_files(DATA) if (DATA / "public").exists() else []
TABLE = (SOURCE / "docs" / "sample_files.md").read_text().splitlines()


def peak_memory():
    """Bytes, of this process until now."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    return sample_files.make_plain(tmp_path_factory.mktemp("plain"))


@pytest.mark.skipif(not FILES, reason="REAL DATA MISSING: public; set BURNISH_DATA")
@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file)[:40])
def test_a_sample_is_processed_or_refused_as_the_table_says(file, plain):
    """`test_bad_input.py` holds that the command line says the same, in one line."""
    before = peak_memory()
    composite = sample_files.Composite(DATA, file, plain)
    assert peak_memory() - before < 1 << 30
    assert composite.output.exists() == (composite.error is None)
    if composite.error:
        assert composite.error.code in ("E_READ_FAILED", "E_MISSING_CHANNEL")
        assert file.name in str(composite.error) and "\n" not in str(composite.error)
    assert sample_files.row(DATA, file, sample_files.descriptions(DATA)[str(file)], composite) in TABLE


@pytest.mark.skipif(not FILES, reason="REAL DATA MISSING: public; set BURNISH_DATA")
def test_the_table_has_a_row_for_each_sample_and_no_more():
    rows = [line.split("`")[1] for line in TABLE if line.startswith("| `")]
    assert rows == [str(file) for file in FILES]

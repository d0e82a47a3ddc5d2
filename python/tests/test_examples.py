"""The examples run as they are shown."""

import pathlib
import re
import subprocess
import sys

import nbclient
import nbformat
import pytest

EXAMPLES = pathlib.Path(__file__).parent.parent / "examples"
GUIDE = EXAMPLES.parent.parent / "docs" / "guide.md"


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.ipynb")), ids=lambda path: path.name)
def test_a_notebook_runs(path):
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(EXAMPLES)}}).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    assert any("text/html" in output.get("data", {}) for output in outputs)
    assert not any(output.output_type == "error" for output in outputs)


def test_the_guide_says_what_is():
    shown = [block for block in re.findall(r"```python\n(.*?)```", GUIDE.read_text("utf-8"), re.S) if "import dalembert" in block]
    assert len(shown) == 1
    names = {}
    exec(shown[0], names)
    assert f"{names['fan'].amplitude.value:.3f}" == "4.554" and "# 4.553…, 'mm', 0.004553…" in shown[0]
    assert names["curve"].units == {"amplitude": "mm"} and len(names["curve"]["amplitude"]) == 1_000_000


def test_a_cluster_of_dask_solves():
    run = subprocess.run([sys.executable, str(EXAMPLES / "dask_cluster.py")], capture_output=True, text=True, timeout=180)
    assert run.returncode == 0, run.stderr
    assert "largest amplitude" in run.stdout, run.stdout

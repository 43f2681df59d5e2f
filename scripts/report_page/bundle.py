"""Vega from Debian's packages, bundled: one script for the page, one for the files; and from specifications to SVG and PNG."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent
NODE_MODULES = pathlib.Path("/usr/share/nodejs")
# By the program, or file, that each package brings.
PACKAGES = {"esbuild": "esbuild", "node": "nodejs", "rsvg-convert": "librsvg2-bin"}

SAID = 2000  # characters at the end of what a tool says when it fails; before them is minified text


class ToolError(Exception):
    """A tool that failed. The message says which, and what it said."""


def missing_packages():
    """Debian's packages that are not there."""
    missing = [package for program, package in PACKAGES.items() if shutil.which(program) is None]
    return missing if (NODE_MODULES / "vega").is_dir() else [*missing, "node-vega"]


def run_tool(command, **more):
    done = subprocess.run([str(c) for c in command], stdin=subprocess.DEVNULL, capture_output=True, check=False, **more)
    if done.returncode:
        raise ToolError(f"{command[0]} failed: {done.stderr.decode(errors='replace').strip()[-SAID:]}")
    return done.stdout


def bundled(file, *options):
    """The text of a script with all that it imports. Stubs stand for what Debian lacks and no chart needs."""
    paths = f"{HERE / 'stubs'}{os.pathsep}{NODE_MODULES}"
    command = ["esbuild", file, "--bundle", "--minify", "--log-level=error", "--charset=utf8", *options]
    return run_tool(command, env=os.environ | {"NODE_PATH": paths}, cwd=HERE).decode()


def page_script():
    """Vega and what draws the page's charts, to stand within a <script>."""
    return bundled("page.js", "--format=iife").replace("</script", "<\\/script")


def drawn(specs, config):
    """{name: text of an SVG} of {name: specification}."""
    with tempfile.TemporaryDirectory() as folder:
        script, given, made = (pathlib.Path(folder) / name for name in ("draw.cjs", "given.json", "made.json"))
        script.write_text(bundled("draw.js", "--platform=node", "--main-fields=module,main", "--format=cjs", "--external:canvas"), encoding="utf-8")
        given.write_text(json.dumps({"specs": specs, "config": config}), encoding="utf-8")
        run_tool(["node", script, given, made])
        return json.loads(made.read_text(encoding="utf-8"))


def write_png(svg_file, png_file, zoom=1.5):
    """Dots by rsvg-convert: `zoom` dots a unit of the picture."""
    run_tool(["rsvg-convert", "--zoom", str(zoom), "--format", "png", "--output", png_file, svg_file])

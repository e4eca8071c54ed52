"""`candela.diagnose()` tells what there is and, where there is nothing, what to do."""

import subprocess
import sys

import candela


def run(*arguments, **variables):
    import os

    return subprocess.run([sys.executable, "-m", "candela", *arguments], env={**os.environ, **variables},
                          capture_output=True, text=True, timeout=120)


def test_it_tells_everything(capsys, renderer):
    found = candela.diagnose()
    assert capsys.readouterr().out == found.text + "\n"
    assert found.works and found.renderer == renderer.context.renderer and found.driver == renderer.context.driver
    assert len(found.attempts) >= 1
    for text in (candela.__version__, found.renderer, found.driver, "candela-gltf.so: gltf", ".glb", "plaza:N",
                 "refines cages", "built-in", "shadows: "):
        assert text in found.text
    for way, outcome in found.attempts:
        assert f"{way}: {outcome}" in found.text


def test_as_a_program():
    ended = run()
    assert ended.returncode == 0 and ended.stderr == "" and "OpenGL contexts" in ended.stdout
    assert run("--help").returncode == 0 and run("--nonsense").returncode == 2


def test_without_any_driver_it_says_what_to_do(tmp_path):
    (tmp_path / "none.json").write_text("{}")
    ended = run(__EGL_VENDOR_LIBRARY_FILENAMES=str(tmp_path / "none.json"))
    assert ended.returncode == 1
    assert "used: none" in ended.stdout and "what to do:" in ended.stdout and "install Mesa's EGL" in ended.stdout
    assert "EGL surfaceless display: " in ended.stdout, "every attempt has its outcome"
    assert "__EGL_VENDOR_LIBRARY_FILENAMES" in ended.stdout


def test_broken_plugins_and_colour_configs_are_told(tmp_path):
    (tmp_path / "candela-broken.so").write_text("no library")
    ended = run(CANDELA_PLUGIN_PATH=str(tmp_path), OCIO=str(tmp_path / "none.ocio"))
    assert "candela-broken.so: not a library" in ended.stdout
    assert "unset OCIO" in ended.stdout


def test_a_context_tells_how_it_was_made():
    with candela.Context(software=True) as context:
        assert context.attempts[-1][1] == context.renderer and not context.closed
    assert context.closed
    assert all(device.description for device in candela.devices())

#!/usr/bin/env python3
"""What a picture with read-back takes from Python, against C++: alternately, in one run, and prints a table.

    cmake --build build/release --target candela_read_back candela_python
    PYTHONPATH=build/release/python build/venv/bin/python python/benchmark/compare_read_back.py
"""

import argparse
import pathlib
import statistics
import subprocess
import time

import candela

CASES = (("plaza:256", 640, 360, 1), ("plaza:4096", 1280, 720, 1), ("plaza:4096", 640, 360, 16), ("cloud:10000", 64, 64, 1))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default=pathlib.Path("build/release/bin/candela_read_back"))
    parser.add_argument("--rounds", type=int, default=15)
    options = parser.parse_args()
    print("| scene | picture | samples | C++, ms | Python, ms | ratio |\n| --- | --- | ---: | ---: | ---: | ---: |")
    for scene, width, height, samples in CASES:
        command = [str(options.program), scene, str(width), str(height), str(samples)]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1) as program:
            with candela.Renderer() as renderer:
                uploaded = renderer.upload(candela.load(scene))

                def in_python() -> float:
                    start = time.perf_counter()
                    frame = renderer.render(uploaded, 0, width=width, height=height, samples=samples, aovs=["depth", "normal"])
                    frame.radiance(), frame["depth"], frame["normal"]
                    return 1e3 * (time.perf_counter() - start)

                def in_cpp() -> float:
                    program.stdin.write("\n")
                    return float(program.stdout.readline())

                in_cpp(), in_python()  # Programs are compiled at the first picture.
                pairs = [(in_cpp(), in_python()) for _ in range(options.rounds)]
            program.stdin.close()
        cpp, python = (statistics.median(times) for times in zip(*pairs))
        print(f"| `{scene}` | {width}×{height} | {samples} | {cpp:.1f} | {python:.1f} | {python / cpp:.2f} |")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""How long the program takes to answer SIGTERM: prints figures, which decide no test.

    tests/cli/signals.py PROGRAM [RUNS]

Every case is started RUNS times (default 12) and stopped at as many moments, spread over its first
seconds, so that each verb, the reading of pictures and, with empty caches, the compilers of the
drivers are met. A file that is being written at that moment is finished first. So a case fails if
its code is neither 143 nor 0 (it was done before), or if it leaves anything but one whole file.
"""
import ast, json, math, os, signal, subprocess, sys, tempfile, time

MILLION = "0.000835"  # radius of about a million points


def pictures(folder):
    """Rounds of these conflict more than they admit: two tones, all there is in little of it."""
    steep = os.path.join(folder, "steep.pgm")
    with open(steep, "w") as file:
        file.write("P2 2 8 10\n" + "0 9\n" * 8)
    halves = os.path.join(folder, "halves.pgm")
    with open(halves, "w") as file:
        file.write("P2 64 64 10\n" + ("0 " * 32 + "10 " * 32 + "\n") * 64)
    return steep, halves


def usable(program):
    listed = subprocess.run([program, "devices", "--json"], stdout=subprocess.PIPE, check=True).stdout
    return sorted({one["backend"] for one in json.loads(listed)["devices"] if one["usable"]})


def cases(program, folder):
    steep, halves = pictures(folder)
    for backend in usable(program):
        place = ["--backend", backend]
        yield f"exact, {backend}", ["sample", "--radius", MILLION] + place, False
        yield f"lines, {backend}", ["sample", "--radius", MILLION, "--mode", "lines"] + place, False
        yield (f"steep field, {backend}",
               ["stipple", steep, "--gamma", "8", "--scale", "0.0005"] + place, False)
        yield (f"two halves, {backend}",
               ["stipple", halves, "--min-importance", "1e-6", "--count", "300000"] + place, False)
        yield (f"relax, {backend}",
               ["sample", "--count", "100000", "--relax", "1000"] + place, False)
        if backend in ("opencl", "vulkan"):
            yield f"cold, {backend}", ["sample", "--radius", "0.01"] + place, True


def is_whole(path):
    """Whether an .npy file has as many bytes after its header as the header's shape needs."""
    with open(path, "rb") as file:
        bytes_ = file.read()
    start = 10 + int.from_bytes(bytes_[8:10], "little")
    header = ast.literal_eval(bytes_[10:start].decode())
    return len(bytes_) - start == math.prod(header["shape"]) * int(header["descr"][2:])


def fault(code, out):
    """What is wrong with an exit code and with the files that a stopped program left, if any."""
    left = os.listdir(out)
    are_whole = left == ["a.npy"] and is_whole(os.path.join(out, "a.npy"))
    is_right = code == 0 and are_whole or code == 143 and (are_whole or not left)
    return None if is_right else f"code {code} and files {left}"


def stop(program, words, delay, cold):
    """Seconds from the signal to the end, and what was wrong."""
    with tempfile.TemporaryDirectory() as out, tempfile.TemporaryDirectory() as cache:
        environment = dict(os.environ)
        if cold:
            environment.update(POCL_CACHE_DIR=cache, MESA_SHADER_CACHE_DISABLE="true")
        process = subprocess.Popen([program] + words + ["-o", os.path.join(out, "a.npy")],
                                   env=environment, stderr=subprocess.DEVNULL)
        time.sleep(delay)
        before = time.monotonic()
        process.send_signal(signal.SIGTERM)
        code = process.wait()
        seconds = time.monotonic() - before
        return seconds, fault(code if code >= 0 else 128 - code, out)


def main():
    program = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 12
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        print(f"{'milliseconds from SIGTERM to the end':<38} least  median    most")
        for name, words, cold in cases(program, folder):
            found = [stop(program, words, (0.05 if cold else 0.2) * (i + 1), cold)
                     for i in range(runs)]
            times = sorted(1000 * seconds for seconds, _ in found)
            bad = [fault for _, fault in found if fault]
            print(f"{name:<38} {times[0]:6.1f} {times[len(times) // 2]:7.1f} {times[-1]:7.1f}"
                  + (f"  FAILED: {bad}" if bad else ""), flush=True)
            failed = failed or bool(bad)
    sys.exit(failed)


if __name__ == "__main__":
    main()

"""Makes a wheel of the module for `pip install .` (PEP 517), by CMake and nothing else.

TOILE_BUILD names a build folder to use; by default it is build/wheel.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[1]


def build_module(folder):
    """Installs the package toile into the folder, and returns where it is."""
    build = os.environ.get("TOILE_BUILD", SOURCE / "build" / "wheel")
    if not (pathlib.Path(build) / "CMakeCache.txt").exists():
        subprocess.run(["cmake", "-S", SOURCE, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        f"-DPython_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "toile_python"], check=True)
    subprocess.run(["cmake", "--install", build, "--component", "python", "--strip", "--prefix", folder],
                   check=True)
    return pathlib.Path(folder) / "lib/python3/dist-packages"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version = re.search(r"project\(toile VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    name = f"toile-{version}-{python}-{python}-{platform}.whl"
    record = []

    def add(wheel, path, content):
        wheel.writestr(path, content)
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record.append(f"{path},sha256={digest},{len(content)}")

    info = f"toile-{version}.dist-info"
    with tempfile.TemporaryDirectory() as folder:
        packages = build_module(folder)
        with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
            for file in sorted(packages.rglob("*")):
                if file.is_file():
                    add(wheel, file.relative_to(packages).as_posix(), file.read_bytes())
            add(wheel, f"{info}/METADATA",
                f"Metadata-Version: 2.1\nName: toile\nVersion: {version}\nRequires-Python: >=3.11\n"
                "Requires-Dist: numpy\nLicense: GPL-3.0-or-later\n".encode())
            add(wheel, f"{info}/WHEEL",
                f"Wheel-Version: 1.0\nGenerator: toile\nRoot-Is-Purelib: false\nTag: {python}-{python}-"
                f"{platform}\n".encode())
            wheel.writestr(f"{info}/RECORD", "\n".join([*record, f"{info}/RECORD,,"]) + "\n")
    return name

"""How pip builds the package: a backend of PEP 517 that needs a C compiler and Python.h, and nothing else.

It compiles the library and what calls it into one extension module.  From Python 3.11 on this keeps to the limited
interface, so that one wheel serves all later versions of Python.  Environment: CC, CFLAGS and LDFLAGS as elsewhere;
ALGSURF_LIBRARY, a libalgsurf.a of position-independent code to link instead of compiling the library; ALGSURF_JOBS,
how many compilers run at once.  Built on Linux with gcc and clang; elsewhere it may work.
"""
import base64
import hashlib
import io
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE / "source" if (HERE / "source").exists() else HERE.parent.parent  # of an sdist, of the repository
EXAMPLES = ["fit.c", "fit_extent.c", "view.c"]  # how the program render fits a view,
EXAMPLES += [f"mesh_{part}.c" for part in ("balance", "data", "make", "net", "open", "rows", "space", "threads", "vertex")]
LIMITED = sys.version_info >= (3, 11) and not sysconfig.get_config_var("Py_GIL_DISABLED")
FLAGS = ["-std=c11", "-O2", "-DNDEBUG", "-fPIC", "-ffp-contract=off", "-fno-math-errno", "-fvisibility=hidden",
         "-ffunction-sections", "-fdata-sections"]


def version():
    text = (ROOT / "include/algsurf/status.h").read_text(encoding="utf-8")
    return ".".join(re.findall(r"#define ALGSURF_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))


def compiler():
    return shlex.split(os.environ.get("CC") or "cc")


def run(command):
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    except OSError as error:
        sys.exit(f"algsurf: no C compiler ({error}); on Debian: apt-get install gcc libc6-dev, or set CC")
    if done.returncode:
        sys.exit(f"algsurf: {shlex.join(command)}\n{done.stdout}")


def headers():
    paths = sysconfig.get_paths()
    folders = [paths["include"], paths["platinclude"]]
    if not any((pathlib.Path(folder) / "Python.h").exists() for folder in folders):
        sys.exit(f"algsurf: no Python.h in {paths['include']}; on Debian: apt-get install python3-dev")
    return [f"-I{folder}" for folder in dict.fromkeys(folders)]


def build_extension(target):
    """Compiles all sources at once, as many as there are processors, and links them."""
    library = os.environ.get("ALGSURF_LIBRARY")
    sources = sorted(HERE.glob("*.c")) + [ROOT / "examples" / name for name in EXAMPLES]
    sources += [] if library else sorted(ROOT.glob("lib/*/*.c"), key=lambda file: -file.stat().st_size)
    flags = FLAGS + [f"-I{ROOT / 'include'}", f"-I{ROOT / 'examples'}"] + headers()
    flags += ["-DPy_LIMITED_API=0x030b0000"] if LIMITED else []
    flags += shlex.split(os.environ.get("CFLAGS", ""))
    with tempfile.TemporaryDirectory() as folder:
        objects = [f"{folder}/{i}.o" for i in range(len(sources))]
        commands = [compiler() + flags + ["-c", str(s), "-o", o] for s, o in zip(sources, objects)]
        with ThreadPoolExecutor(int(os.environ.get("ALGSURF_JOBS", 0)) or os.cpu_count()) as pool:
            list(pool.map(run, commands))
        exports = pathlib.Path(folder) / "exports"
        exports.write_text("{ global: PyInit__algsurf; local: *; };", encoding="utf-8")
        link = ["-bundle", "-undefined", "dynamic_lookup", "-Wl,-dead_strip", "-Wl,-exported_symbol,_PyInit__algsurf"]
        if sys.platform != "darwin":
            link = ["-shared", "-static-libgcc", "-Wl,--gc-sections", "-Wl,-s", f"-Wl,--version-script={exports}"]
        link += shlex.split(os.environ.get("LDFLAGS", ""))
        run(compiler() + objects + ([library] if library else []) + link + ["-lm", "-pthread", "-o", str(target)])


def platform_of(extension):
    """linux_x86_64, say; manylinux_2_34_x86_64 if version 2.34 of the GNU libc is the newest that it asks for."""
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    asked = [int(minor) for minor in re.findall(rb"GLIBC_2\.(\d+)", extension.read_bytes())]
    return re.sub("^linux", f"manylinux_2_{max(asked)}", platform) if asked else platform


def metadata():
    text = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    value = {key: re.search(rf'^{key} = (.*)$', text, re.M).group(1).strip('"') for key in
             ("name", "description", "requires-python")}
    return (f"Metadata-Version: 2.1\nName: {value['name']}\nVersion: {version()}\nSummary: {value['description']}\n"
            f"License: MIT\nRequires-Python: {value['requires-python']}\nRequires-Dist: numpy\n"
            f"Description-Content-Type: text/markdown\n\n{(HERE / 'README.md').read_text(encoding='utf-8')}")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    suffix = ".abi3.so" if LIMITED else sysconfig.get_config_var("EXT_SUFFIX")
    python = f"cp{sys.version_info[0]}{'11' if LIMITED else sys.version_info[1]}"
    abi = "abi3" if LIMITED else sysconfig.get_config_var("SOABI").replace("cpython-", "cp").split("-")[0]
    with tempfile.TemporaryDirectory() as folder:
        extension = pathlib.Path(folder) / f"_algsurf{suffix}"
        build_extension(extension)
        tag = f"{python}-{abi}-{platform_of(extension)}"
        files = {f"algsurf/{file.name}": file.read_bytes() for file in sorted((HERE / "algsurf").iterdir())
                 if file.suffix in (".py", ".pyi", ".typed") or file.name == "py.typed"}
        files[f"algsurf/{extension.name}"] = extension.read_bytes()
    info = f"algsurf-{version()}.dist-info"
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: algsurf\nRoot-Is-Purelib: false\n"
                              f"Tag: {tag}\n").encode()
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    wheel = f"algsurf-{version()}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name)  # of 1980, so that the same sources make the same wheel
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """The package, and in source/ what of the repository it compiles."""
    base = f"algsurf-{version()}"
    own = sorted(HERE.glob("*.*")) + sorted((HERE / "algsurf").glob("*.*"))
    needed = [ROOT / "LICENSE"] + sorted(ROOT.glob("lib/*/*.[ch]")) + sorted(ROOT.glob("include/algsurf/*.h"))
    needed += [ROOT / "examples" / name for name in EXAMPLES] + sorted(ROOT.glob("examples/*.h"))
    with tarfile.open(pathlib.Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
        for file in own:
            if file.is_file():
                archive.add(file, f"{base}/{file.relative_to(HERE)}")
        for file in needed:
            archive.add(file, f"{base}/source/{file.relative_to(ROOT)}")
        info = tarfile.TarInfo(f"{base}/PKG-INFO")
        info.size = len(metadata().encode())
        archive.addfile(info, io.BytesIO(metadata().encode()))
    return f"{base}.tar.gz"

"""Good files of every kind that the program opens, and the commands that open them.

A kind says how its files are made, where in the folder of a case they stand, which of them are damaged, and which
commands and readers are then called.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

TRIANGLES = np.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4]], dtype=np.int64)


@dataclass(frozen=True)
class Call:
    """One command, or a reader of the library that has no command of its own.

    Attributes:
        argv: what stands behind ``sceneweaver``; a first word with @ names a reader. ``{in}`` and ``{out}`` are the
            folders of the case.
        limit: wall seconds that it may take: its ``--time-limit``, or a number that is generous.
        writes: names in ``out`` that it writes, where a link may stand. A link that a command is told to write to is
            no case: its user said so.
        weight: how often it is chosen, beside the others.
    """

    argv: str
    limit: float = 20.0
    writes: tuple[str, ...] = ()
    weight: int = 2


@dataclass(frozen=True)
class Kind:
    """A kind of file; see the module."""

    make: Callable[[Path], None]
    targets: tuple[str, ...]
    calls: tuple[Call, ...]
    place: str = "in"
    env: dict[str, str] = field(default_factory=dict[str, str])
    slow: bool = False


def _scenes(folder: Path) -> None:
    import sceneweaver as sw

    sw.Scene.example("study").save(folder / "scene.json")


def _cameras(folder: Path) -> None:
    _scenes(folder)
    k = [[200.0, 0, 100], [0, 200.0, 75], [0, 0, 1]]
    pose = [[1.0, 0, 0, 1], [0, 0, 1, 1], [0, -1, 0, 1.5], [0, 0, 0, 1]]
    rows = [
        {"name": "a", "eye": [1, 1, 1.5], "target": [2, 2, 1], "fov": 60, "width": 64, "height": 48},
        {"K": k, "camera_to_world_opencv": pose, "width": 64, "height": 48},
    ]
    (folder / "cameras.json").write_text(json.dumps({"cameras": rows}))


def _run(folder: Path) -> None:
    """A run that was made in a process of its own: the engine is not to be started in this one."""
    request = "a small bathroom with a toilet and a sink"
    options = "--steps 1 --candidates 4 --no-pictures --export none --device cpu --time-limit 300"
    _command(f'design "{request}" --out {folder} {options}')


def _command(line: str) -> None:
    import shlex
    import subprocess
    import sys

    command = [sys.executable, "-m", "sceneweaver", *shlex.split(line)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise RuntimeError(f"{line}: {done.stderr}")


def _records(folder: Path) -> None:
    """Questions and answers of a model, as a run keeps them."""
    from sceneweaver.llm.records import FOLDER_SCHEMA, SCHEMA

    endpoint = {"schema": FOLDER_SCHEMA, "title": "openai:small", "pictures": True}
    sessions = [{"first": 1, "kept": 0, "limits": {}}]
    (folder / "endpoint.json").write_text(json.dumps({**endpoint, "sessions": sessions}, indent=1))
    record = {
        **{"schema": SCHEMA, "purpose": "plan", "digest": "0" * 64, "answer": {"steps": 3}, "failure": None},
        **{"usage": {"input_tokens": 10, "output_tokens": 5, "requests": 1}, "exchanges": [], "seconds": 0.5},
    }
    for number in (1, 2):
        (folder / f"{number:03d}-plan.json").write_text(json.dumps(record, indent=1))


def _room(folder: Path) -> None:
    from sceneweaver.io import packaged

    text = packaged.text("sceneweaver.knowledge", "rooms", "bathroom.yaml")
    rows = [line for line in text.splitlines() if not line.startswith("words:")]
    text = "\n".join(rows).replace("name: bathroom", "name: hut\nwords: [garden hut]")
    (folder / "hut.yaml").write_text(text + "\n")


def _spec(folder: Path) -> None:
    (folder / "prompts.csv").write_text("prompt,weight\na small bathroom,1\na study with two desks,2\n")
    rows = ("schema: sceneweaver.dataset/1", "name: tiny", "count: 2", "product: layouts")
    more = ("requests:", "  kinds: {bathroom: 1, study: 1}", "rooms: {candidates: 4, layouts: 2, objects: [2, 6]}")
    (folder / "spec.yaml").write_text("\n".join((*rows, *more, "splits: {train: 0.5, test: 0.5}")) + "\n")


def _prices(folder: Path) -> None:
    rows = "openai:gpt-4.1: {input: 1.8, cached_input: 0.45, output: 7.2}\n  small: {input: 1, output: 2}"
    (folder / "prices.yaml").write_text(f"currency: EUR\nmodels:\n  {rows}\n")


def _chair():
    """A seat with a back, 0.5 m wide, z up."""
    import trimesh

    seat = trimesh.creation.box((0.5, 0.5, 0.45), trimesh.transformations.translation_matrix((0, 0, 0.225)))
    back = trimesh.creation.box((0.05, 0.5, 0.5), trimesh.transformations.translation_matrix((-0.225, 0, 0.7)))
    return trimesh.util.concatenate([seat, back])


def _mesh(suffix: str) -> Callable[[Path], None]:
    def make(folder: Path) -> None:
        chair = _chair()
        if suffix == ".gltf":
            from trimesh.exchange.gltf import export_gltf

            for name, content in export_gltf(chair.scene()).items():
                (folder / name.replace("model.gltf", "chair.gltf")).write_bytes(content)
        elif suffix == ".obj":
            from trimesh.exchange.obj import export_obj

            text = export_obj(chair, include_normals=True)
            (folder / "chair.obj").write_text("mtllib chair.mtl\nusemtl wood\n" + text)
            _image(folder / "wood.png", 8)
            (folder / "chair.mtl").write_text("newmtl wood\nKd 0.6 0.4 0.2\nmap_Kd wood.png\n")
        else:
            chair.export(folder / f"chair{suffix}")
        if suffix == ".stl":
            (folder / "text").mkdir()
            (folder / "text" / "stool.stl").write_text(chair.export(file_type="stl_ascii"))

    return make


def _image(path: Path, side: int, color: tuple[int, int, int] = (120, 90, 60)) -> None:
    from PIL import Image

    Image.new("RGB", (side, side), color).save(path)


def _checked(folder: Path) -> None:
    """A scene beside the mesh files of what stands in it."""
    import sceneweaver as sw

    data = json.loads(sw.Scene.example("study").dumps())
    (folder / "meshes").mkdir()
    for thing, suffix in zip(data["objects"], (".obj", ".glb", ".stl", ".ply"), strict=False):
        thing["asset"] = thing["id"].replace(" ", "_")
        _chair().export(folder / "meshes" / f"{thing['asset']}{suffix}")
    (folder / "scene.json").write_text(json.dumps(data))


def _mjcf(folder: Path) -> None:
    (folder / "chair").mkdir()
    _chair().export(folder / "chair" / "seat.obj")
    _chair().export(folder / "chair" / "hull.stl")
    (folder / "chair" / "more.xml").write_text("<mujocoinclude><asset/></mujocoinclude>")
    (folder / "chair" / "model.xml").write_text(
        '<mujoco model="chair"><compiler angle="radian" meshdir="."/><include file="more.xml"/>'
        '<asset><mesh name="seat" file="seat.obj" scale="1 1 1"/><mesh name="hull" file="hull.stl"/></asset>'
        '<worldbody><body name="chair" pos="0 0 0.1"><geom type="mesh" mesh="seat" contype="0" conaffinity="0" '
        'group="1" euler="0 0 1.57"/><geom type="mesh" mesh="hull" mass="2" euler="0 0 1.57"/>'
        "</body></worldbody></mujoco>\n"
    )


def _usd(suffix: str) -> Callable[[Path], None]:
    def make(folder: Path) -> None:
        chair = _chair()
        points = ", ".join("({}, {}, {})".format(*row) for row in chair.vertices.round(4).tolist())
        corners = ", ".join(str(int(k)) for k in chair.faces.ravel())
        text = (
            '#usda 1.0\n(\n    defaultPrim = "Chair"\n    upAxis = "Z"\n    metersPerUnit = 1\n)\n\n'
            'def Xform "Chair"\n{\n    double3 xformOp:translate = (0, 0, 0.1)\n'
            '    uniform token[] xformOpOrder = ["xformOp:translate"]\n\n    def Mesh "seat"\n    {\n'
            f"        int[] faceVertexCounts = [{', '.join(['3'] * len(chair.faces))}]\n"
            f"        int[] faceVertexIndices = [{corners}]\n        point3f[] points = [{points}]\n"
            "        color3f[] primvars:displayColor = [(0.5, 0.4, 0.3)]\n    }\n}\n"
        )
        source = folder / "chair.usda"
        source.write_text(text)
        if suffix == ".usda":
            (folder / "room.usda").write_text(
                '#usda 1.0\n(\n    subLayers = [@./chair.usda@]\n)\n\ndef Xform "More" (\n'
                "    references = @chair.usda@</Chair>\n)\n{\n}\n"
            )
            return
        _python(
            "import sys; from pxr import Sdf, UsdUtils\n"
            "source, made = sys.argv[1:]\n"
            "if made.endswith('z'): UsdUtils.CreateNewUsdzPackage(source, made)\n"
            "else: Sdf.Layer.FindOrOpen(source).Export(made)",
            str(source),
            str(folder / f"chair{suffix}"),
        )
        source.unlink()

    return make


def _python(text: str, *argv: str) -> None:
    import subprocess
    import sys

    subprocess.run([sys.executable, "-c", text, *argv], check=True, capture_output=True)


def _manifest(folder: Path) -> None:
    _chair().export(folder / "chair.obj")
    row = {"file": "chair.obj", "category": "chair", "up": "z", "front": "x", "unit": "m", "mass": 4, "width": 0.5}
    (folder / "manifest.json").write_text(json.dumps([row, {**row, "yaw": 90, "licence": "CC0"}], indent=1))


def _manifest_csv(folder: Path) -> None:
    _chair().export(folder / "chair.obj")
    rows = "file,category,up,front,unit,mass,width\nchair.obj,chair,z,x,m,4,0.5\nchair.obj,stool,z,-x,cm,,50\n"
    (folder / "manifest.csv").write_text(rows)


def _objathor(folder: Path) -> None:
    (folder / "abc").mkdir()
    _chair().export(folder / "abc" / "abc.glb")
    row = {"category": "chair", "scale": 1.0, "pose_z_rot_angle": 0.5, "height": 90, "material": "wood"}
    (folder / "annotations.json").write_text(json.dumps({"abc": {**row, "description": "a chair"}}, indent=1))


def _abo(folder: Path) -> None:
    (folder / "original").mkdir()
    _chair().export(folder / "original" / "c1.glb")
    (folder / "3dmodels.csv").write_text("3dmodel_id,path,extent_x\nC1,c1.glb,0.5\nC2,c1.glb,0.5\n")
    name = {"language_tag": "en_GB", "value": "CHAIR"}
    row = {"3dmodel_id": "C1", "product_type": [{"value": "CHAIR"}], "item_name": [name], "color": [name]}
    (folder / "listings_0.json").write_text(json.dumps(row) + "\n")


def _future(folder: Path) -> None:
    (folder / "m1").mkdir()
    _chair().export(folder / "m1" / "raw_model.obj")
    row = {"model_id": "m1", "category": "Lounge Chair / Cafe Chair", "super-category": "Chair", "style": "Modern"}
    (folder / "model_info.json").write_text(json.dumps([row], indent=1))


def _store(folder: Path) -> None:
    """An asset store with one chair that was drawn."""
    from sceneweaver.assets.imports.prepare import content_hash
    from sceneweaver.assets.parametric import make
    from sceneweaver.assets.store import Store

    asset = make("stool", 0)
    content = content_hash(asset)
    Store(folder).add(asset, content)
    shutil.rmtree(folder / "drafts", ignore_errors=True)
    (folder / "id.txt").write_text(f"{asset.id}\n")


def _textures(folder: Path) -> None:
    (folder / "oakish").mkdir()
    for name in ("oak_Color", "oak_Roughness", "oak_NormalGL"):
        _image(folder / "oakish" / f"{name}.png", 16)
    (folder / "oakish" / "texture.yaml").write_text("size: [0.5, 0.5]\n")


def _baked(folder: Path) -> None:
    """The cache of a pattern, under the name that it is looked for."""
    from sceneweaver.assets.textures.library import cache_folder, maps

    before = os.environ.get("XDG_CACHE_HOME")
    os.environ["XDG_CACHE_HOME"] = str(folder)
    try:
        maps("felt")
        if not list(cache_folder().glob("*.npz")):
            raise RuntimeError("nothing was baked")
    finally:
        os.environ.pop("XDG_CACHE_HOME")
        if before is not None:
            os.environ["XDG_CACHE_HOME"] = before


def _bank(folder: Path) -> None:
    """Layouts of rooms for many worlds, of as few arrays as are read."""
    from dataclasses import asdict

    from sceneweaver.envs.batched.bank import Slots
    from sceneweaver.envs.batched.structs import GOAL

    slots = asdict(Slots(4, (1, 2), (3, 4), (1,)))
    about = {"names": [["a"]], "instructions": ["go"], "dropped": [0], "slots": slots}
    arrays = {"room/size": np.ones((1, 3)), "layout/goals": np.zeros((1, 2), dtype=GOAL), "layout/room": np.zeros(1)}
    np.savez_compressed(folder / "bank.npz", about=np.array(json.dumps(about)), **arrays)


def _results(folder: Path) -> None:
    from dataclasses import asdict

    from sceneweaver.bench.results import Row, arrow_schema, pyarrow

    given = ("study", "rooms", "0" * 64, 4, 12, 0.5)
    rows = [
        asdict(Row(method, *given, seed, 8, look, look, 1, 0.1 * look, valid=0.5 * look, best_energy=1.0 - look))
        for method in ("adam", "search")
        for seed in (0, 1)
        for look in (0, 1)
    ]
    about = json.dumps({"settings": {}, "versions": {}, "machine": {}}).encode()
    pa = pyarrow()
    pa.parquet.write_table(pa.Table.from_pylist(rows, arrow_schema(about)), folder / "results.parquet")


def _card(folder: Path) -> None:
    from sceneweaver.io import packaged

    (folder / "card.yaml").write_text(packaged.text("sceneweaver", "toolcards", "init_prior.yaml"))


def _library(folder: Path) -> None:
    import sceneweaver as sw
    from sceneweaver.knowledge.library import library_scenes

    for name in ("study", "bedroom"):
        sw.Scene.example(name).save(folder / f"{name}.json")
    rows = [card.model_dump(mode="json") for card in library_scenes(folder)]
    (folder / "index.json").write_text(json.dumps(rows, indent=1))


def _set(folder: Path) -> None:
    """A finished data set of three rooms."""
    from sceneweaver.datasets import Folder
    from sceneweaver.datasets.engines.manifest import create
    from sceneweaver.datasets.files import pack
    from tests.datasets.small import make_small, small_spec

    given = {"block": 3}
    create(Folder(folder), small_spec(3, **given), "cpu", {"spec.yaml": b""})
    pack(Folder(folder), make_small(folder, 3, **given))


def _blocks(folder: Path) -> None:
    """A data set that was begun: its blocks are made and not yet packed."""
    from sceneweaver.datasets import Folder
    from sceneweaver.datasets.engines.manifest import create
    from tests.datasets.small import make_small, small_spec

    create(Folder(folder), small_spec(4), "cpu", {"spec.yaml": b""})
    make_small(folder, 4)


_IMPORT = "assets import {in} --store {out}/store --time-limit 10"
_LINKS = ("store/objects", "store/cache", "store/drafts")


def _imported(*files: str) -> tuple[Call, ...]:
    """The commands that read mesh files."""
    given = "--store {out}/store --time-limit 10"
    one = tuple(Call(f"assets import {{in}}/{file} {given}", 10, _LINKS) for file in files)
    return (*one, Call(f"{_IMPORT} --json", 20, _LINKS))  # the limit is that of each of two files


_ENGINE = "--candidates 4 --device cpu --time-limit 10"
_SET = (
    Call("dataset verify {out} --workers 1", 20, ("verification.json",), 4),
    Call("dataset status {out}", 20),
    Call("dataset extract {out} 000000001 {out}/one", 20, ("one",)),
    Call("dataset report {out} --pictures 0", 20, ("report.html",)),
    Call("dataset resume {out} --time-limit 10 --workers 1 --device cpu", 10, ("work", "data", "meta", "README.md")),
    Call("@rows {out}", 20),
)

KINDS: dict[str, Kind] = {
    "scene": Kind(
        _scenes,
        ("scene.json",),
        (
            Call("check {in}/scene.json --json --metrics {out}/metrics.json", 20, ("metrics.json",), 6),
            Call("check {in}/scene.json --picture {out}/plan.png", 20, ("plan.png",)),
            Call("check {in}/scene.json --openable", 20),
            Call("render {in}/scene.json --out {out}/plan.png --width 400", 20, ("plan.png",), 4),
            Call("export {in}/scene.json --out {out}/room.glb --no-textures", 20, ("room.glb",)),
            Call(
                "export {in}/scene.json --out {out}/files --to mjcf --no-textures",
                20,
                ("files/scene.xml", "files/meshes"),
            ),
            Call("export {in}/scene.json --out {out}/files --to urdf,scenestate", 20, ("files/urdf", "files/models")),
            Call(f"refine {{in}}/scene.json --out {{out}} {_ENGINE} --no-picture", 10, ("scene.json", "metrics.json")),
            Call(f"repair {{in}}/scene.json --out {{out}} {_ENGINE} --no-picture", 10, ("scene.json",), 1),
            Call("@view {in}/scene.json", 20),
        ),
    ),
    "cameras": Kind(
        _cameras,
        ("cameras.json",),
        (
            Call("@cameras {in}/cameras.json", 20, (), 3),
            Call(
                "render {in}/scene.json --passes depth --cameras {in}/cameras.json --out {out} --width 200 "
                "--height 150 --format npz",
                20,
                ("camera-1.npz", "a.npz"),
                1,
            ),
        ),
    ),
    "run": Kind(
        _run,
        ("state.json", "metrics.json", "request.json", "scene.json", "steps/*/*.json"),
        (
            Call(
                f"design --out {{out}} --no-pictures --export none {_ENGINE}",
                10,
                ("scene.json", "state.json", "metrics.json", "request.json", "steps"),
                3,
            ),
            Call("design --replay {out} --out {out}/again --no-pictures --export none --time-limit 10", 10),
            Call("@view {out}", 20, (), 3),
            Call("@request {out}/request.json", 20),
        ),
        place="out",
        slow=True,
    ),
    "records": Kind(_records, ("*.json",), (Call("@records {in}", 20),)),
    "room": Kind(
        _room,
        ("hut.yaml",),
        (
            Call("knowledge list", 20, (), 6),
            Call("knowledge show hut", 20, (), 4),
            Call(f'design "a garden hut" --out {{out}} --no-pictures --export none {_ENGINE}', 10, (), 1),
        ),
        env={"SCENEWEAVER_ROOMS": "{in}"},
    ),
    "spec": Kind(
        _spec,
        ("spec.yaml",),
        (
            Call("@begin {in}/spec.yaml {out}/set", 20, ("set", "set/work"), 6),
            Call("dataset make {in}/spec.yaml --out {out}/set --workers 1 --device cpu --time-limit 10", 10, ("set",)),
            Call("dataset plan {in}/spec.yaml --sample 1 --workers 1 --device cpu", 60, (), 1),
        ),
    ),
    "prices": Kind(
        _prices,
        ("prices.yaml",),
        (
            Call(
                "design 'a study' --prices {in}/prices.yaml --max-cost 1 --model openai:gpt-4.1 --strict "
                "--base-url http://127.0.0.1:9/v1 --out {out}/run --time-limit 10",
                10,
                ("run",),
                1,
            ),
            Call("@prices {in}/prices.yaml", 20, (), 3),
        ),
    ),
    "glb": Kind(_mesh(".glb"), ("*.glb",), (*_imported("chair.glb"), Call("@view {in}/chair.glb", 20))),
    "gltf": Kind(_mesh(".gltf"), ("*",), _imported("chair.gltf")),
    "obj": Kind(_mesh(".obj"), ("*",), _imported("chair.obj")),
    "stl": Kind(_mesh(".stl"), ("*.stl", "text/*.stl"), _imported("chair.stl", "text/stool.stl")),
    "ply": Kind(_mesh(".ply"), ("*.ply",), _imported("chair.ply")),
    "off": Kind(_mesh(".off"), ("*.off",), _imported("chair.off")),
    "checked": Kind(
        _checked,
        ("meshes/*",),
        (Call("check {in}/scene.json --meshes {in}/meshes --json", 20),),
    ),
    "mjcf": Kind(
        _mjcf,
        ("chair/*",),
        (
            Call(f"{_IMPORT} --format mjcf", 10, _LINKS, 3),
            Call("assets import {in}/chair/model.xml --store {out}/store --time-limit 10", 10, _LINKS),
            Call("@spec_of {in}/chair/model.xml", 20),
        ),
    ),
    "usda": Kind(_usd(".usda"), ("*.usda",), _imported("chair.usda", "room.usda")),
    "usdc": Kind(_usd(".usdc"), ("*.usdc",), _imported("chair.usdc")),
    "usdz": Kind(_usd(".usdz"), ("*.usdz",), _imported("chair.usdz")),
    "manifest": Kind(_manifest, ("manifest.json",), _imported()),
    "csv": Kind(_manifest_csv, ("manifest.csv",), _imported()),
    "objathor": Kind(_objathor, ("annotations.json",), (Call(f"{_IMPORT} --format objathor", 10, _LINKS),)),
    "abo": Kind(_abo, ("3dmodels.csv", "listings_0.json"), _imported()),
    "future3d": Kind(_future, ("model_info.json",), _imported()),
    "store": Kind(
        _store,
        ("objects/*/*/*",),
        (
            Call("assets list --store {in} --source parametric-store", 20),
            Call("@asset {in}", 20, (), 3),
        ),
    ),
    "textures": Kind(
        _textures,
        ("oakish/*",),
        (Call("@maps oakish", 20),),
        env={"SCENEWEAVER_TEXTURES": "{in}"},
    ),
    "baked": Kind(
        _baked,
        ("sceneweaver/**/*.npz",),
        (Call("@maps felt", 20),),
        place="out",
        env={"XDG_CACHE_HOME": "{out}"},
        slow=True,
    ),
    "bank": Kind(_bank, ("bank.npz",), (Call("@bank {in}/bank.npz", 20),)),
    "results": Kind(_results, ("results.parquet",), (Call("bench compare {in}", 20), Call("@about {in}", 20))),
    "card": Kind(_card, ("card.yaml",), (Call("@card {in}/card.yaml", 20),)),
    "library": Kind(_library, ("*.json",), (Call("@library {in}", 20),)),
    "set": Kind(_set, ("*", "data/*", "meta/*", "**/*.tar", "**/*.parquet"), _SET, place="out"),
    "blocks": Kind(_blocks, ("*.json", "work/**/*"), (_SET[4], _SET[1], _SET[0]), place="out", slow=True),
}


def read(name: str, *given: str) -> None:
    """Call a reader of the library that has no command; what is wrong is an InputError."""
    place = Path(given[0])
    if name == "view":
        from sceneweaver.cli.view import show

        show(place)[0]()
    elif name == "cameras":
        from sceneweaver.render.pass_files import read_shots

        read_shots(place, 64, 48)
    elif name == "request":
        from sceneweaver.agent.request_file import RequestFile

        RequestFile.load(place)
    elif name == "records":
        from sceneweaver.llm.records import read_records

        read_records(place)
    elif name == "begin":
        from sceneweaver.datasets.engines import begin

        begin(place, Path(given[1]), "cpu")
    elif name == "prices":
        from sceneweaver.llm import Prices

        Prices.load(place)
    elif name == "spec_of":
        from sceneweaver.io import read_spec

        read_spec(place)
    elif name == "asset":
        from sceneweaver.assets.store import Store

        Store(place).load((place / "id.txt").read_text().strip())
    elif name == "maps":
        from sceneweaver.assets.textures.library import maps

        maps(given[0])
    elif name == "bank":
        from sceneweaver.envs.batched.bank import Bank

        Bank.load(place)
    elif name == "about":
        from sceneweaver.bench import read_about, read_runs

        read_about(place)
        read_runs(place)
    elif name == "card":
        from sceneweaver.io import read_text
        from sceneweaver.tools.card import read_card

        read_card(read_text(place))
    elif name == "library":
        from sceneweaver.knowledge.library import library_scenes, load_scene

        for card in library_scenes(place):
            load_scene(card.name, place)
    elif name == "rows":
        from sceneweaver.datasets import Folder
        from sceneweaver.datasets.reading import rows_of

        for _ in rows_of(Folder(place)):
            pass
    else:
        raise ValueError(f"no reader {name}")

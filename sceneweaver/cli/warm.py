"""``sceneweaver warm``: kernels are compiled ahead, so that no first run waits for that."""

from __future__ import annotations

import time

import typer

from sceneweaver.io import InputError

from .output import print_json
from .streams import no_chatter


def run_warm(device: str, arch: int | None = None, *, as_json: bool) -> int:
    """Compile all that designs, plans, refinements, pictures and data sets launch on a device.

    ``arch``: for GPUs of that compute capability instead.
    """
    begun = time.monotonic()
    with no_chatter():
        from sceneweaver.layout.devices import pick_devices
        from sceneweaver.layout.warming import kernel_modules
        from sceneweaver.plans.solve_run import kernel_modules as plan_modules
        from sceneweaver.render.tracing.tracer import kernel_modules as picture_modules
        from sceneweaver.runtime.compiling import compile_for, kernel_cache, load

        devices = pick_devices(device) if arch is None else [f"sm_{arch}"]
        modules = {name: [*kernel_modules(name), *picture_modules(), *plan_modules()] for name in devices}
        if arch is None:
            compiled = sum(load(name, own) for name, own in modules.items())
        else:
            try:
                compiled = compile_for(arch, modules[devices[0]])
            except ValueError as error:
                raise InputError(f"arch: {error}") from error
        folder = kernel_cache()
    seconds, total = time.monotonic() - begun, len(modules[devices[0]])
    if as_json:
        facts = {"devices": devices, "modules": total, "compiled": compiled, "seconds": round(seconds, 3)}
        print_json({**facts, "folder": str(folder), "exit_code": 0})
        return 0
    done = f"{compiled} of {total} modules of kernels compiled in {seconds:.1f} s"
    said = done if compiled else f"all {total} modules of kernels are compiled already"
    typer.echo(f"{', '.join(devices)}: {said}; the cache is {folder}")
    return 0

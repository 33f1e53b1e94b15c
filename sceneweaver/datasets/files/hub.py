"""Card and tables of a data set on Hugging Face's hub, or on another server that speaks its protocol."""

from __future__ import annotations

import os
from pathlib import Path

from sceneweaver.scene import InputError, MissingDependencyError

from ..folder import Folder

NAMES = ("README.md", "LICENSES.md", "croissant.json", "checksums.sha256", "dataset.json", "spec.yaml", "meta/*")
"""What is uploaded, as patterns: all but data and assets."""


def push_card(
    path: Path, repo: str, *, endpoint: str | None = None, token_env: str = "HF_TOKEN", dry_run: bool = False
) -> list[str]:
    """Upload what describes a data set: card, licences, Croissant metadata, checksums, specification and tables.

    Args:
        path: the data set.
        repo: where to, as ``owner/name``; it is made, private, where it is not there.
        endpoint: address of the server; None: the hub.
        token_env: name of the environment variable that holds the access token.
        dry_run: only list the files.

    Returns:
        The files, relative to the root.

    Raises:
        InputError: the data set is not packed, the variable is not set, or the server refuses.
        MissingDependencyError: huggingface_hub is not installed.
    """
    if not Folder(path).checksums.exists():
        raise InputError(f"{path}: not packed yet; finish it with: sceneweaver dataset resume {path}")
    files = sorted({file.relative_to(path).as_posix() for name in NAMES for file in path.glob(name) if file.is_file()})
    if dry_run:
        return files
    token = os.environ.get(token_env)
    if not token:
        raise InputError(f"--token-env: {token_env} is not set; put an access token with write permission into it")
    try:
        from huggingface_hub import CommitOperationAdd, HfApi
        from huggingface_hub.errors import HfHubHTTPError, HFValidationError
    except ModuleNotFoundError:
        raise MissingDependencyError(
            "push-card needs huggingface_hub; install it with: pip install sceneweaver[hub]"
        ) from None
    api = HfApi(endpoint=endpoint, token=token)
    try:
        api.create_repo(repo, repo_type="dataset", private=True, exist_ok=True)
        added = [CommitOperationAdd(name, path / name) for name in files]
        api.create_commit(repo, added, commit_message="Card and tables", repo_type="dataset")
    except (HFValidationError, HfHubHTTPError, OSError) as error:
        text = " ".join(str(error).split()).replace(token, "***")
        raise InputError(f"--repo: {repo}: {text[:200]}") from None
    return files

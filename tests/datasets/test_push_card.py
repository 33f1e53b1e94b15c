"""Card and tables on a hub: only these, and no token in any output."""

import huggingface_hub
import pytest

from sceneweaver.datasets import Folder
from sceneweaver.datasets.files import pack, push_card
from sceneweaver.scene import InputError
from tests.datasets.small import make_small

TOKEN = "hf_secret"


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    root = tmp_path_factory.mktemp("packed")
    pack(Folder(root), make_small(root, 2))
    return root


class Hub:
    """Stands for `HfApi`."""

    def __init__(self, endpoint=None, token=None):
        self.calls.append(("api", endpoint, token))

    def create_repo(self, repo, **options):
        self.calls.append(("create", repo, options))

    def create_commit(self, repo, operations, **options):
        if self.error:
            raise self.error
        self.calls.append(("commit", repo, [o.path_in_repo for o in operations], options))


@pytest.fixture
def hub(monkeypatch):
    Hub.calls, Hub.error = [], None
    monkeypatch.setattr(huggingface_hub, "HfApi", Hub)
    monkeypatch.setenv("HUB", TOKEN)
    return Hub


def test_what_describes_a_data_set_is_uploaded_and_nothing_else(packed, hub):
    files = push_card(packed, "me/rooms", endpoint="http://localhost:1", token_env="HUB")
    assert {"README.md", "croissant.json", "LICENSES.md", "meta/index.parquet", "meta/assets.parquet"} <= set(files)
    assert not any(name.startswith(("data/", "assets/", "work/")) for name in files)
    api, create, commit = hub.calls
    assert api == ("api", "http://localhost:1", TOKEN)
    assert create == ("create", "me/rooms", {"repo_type": "dataset", "private": True, "exist_ok": True})
    assert commit[1:3] == ("me/rooms", files) and commit[3]["repo_type"] == "dataset"
    assert TOKEN not in str(files)


def test_a_dry_run_needs_neither_token_nor_server(packed, hub, monkeypatch):
    monkeypatch.delenv("HUB")
    assert "README.md" in push_card(packed, "me/rooms", token_env="HUB", dry_run=True)
    assert hub.calls == []


def test_a_missing_token_is_named_by_its_variable(packed, hub):
    with pytest.raises(InputError, match="--token-env: NOWHERE is not set"):
        push_card(packed, "me/rooms", token_env="NOWHERE")


def test_what_the_server_says_is_one_line_without_the_token(packed, hub):
    hub.error = OSError(f"refused:\nbearer {TOKEN} may not write")
    with pytest.raises(InputError) as caught:
        push_card(packed, "me/rooms", token_env="HUB")
    assert "may not write" in str(caught.value)
    assert TOKEN not in str(caught.value) and "\n" not in str(caught.value)
    assert caught.value.__suppress_context__


def test_a_set_that_is_not_packed_is_refused(tmp_path, hub):
    with pytest.raises(InputError, match="not packed yet"):
        push_card(tmp_path, "me/rooms", token_env="HUB")


def test_a_server_that_is_not_there_is_one_line(packed, monkeypatch):
    monkeypatch.setenv("HUB", TOKEN)
    with pytest.raises(InputError, match=r"^--repo: me/rooms: [^\n]*$"):
        push_card(packed, "me/rooms", endpoint="http://127.0.0.1:9", token_env="HUB")

"""The only place that opens files: what others wrote is bounded on the way in, what is ours is whole on the way out.

Whatever is wrong with a file raises InputError with one line that names the file and the fix. Nothing outside of this
floor opens files, archives, tables, images or meshes (``tests/io/test_one_door.py``).
"""

from .errors import InputError as InputError
from .errors import MissingDependencyError as MissingDependencyError
from .errors import SceneWeaverError as SceneWeaverError
from .reading import MAX_BYTES as MAX_BYTES
from .reading import MAX_UNPACKED as MAX_UNPACKED
from .reading import Place as Place
from .reading import lines_unpacked as lines_unpacked
from .reading import open_regular as open_regular
from .reading import open_unpacked as open_unpacked
from .reading import read_bytes as read_bytes
from .reading import read_unpacked as read_unpacked
from .reading import reason as reason
from .writing import SUFFIX as SUFFIX
from .writing import TEMPORARY as TEMPORARY
from .writing import locked as locked
from .writing import own_folder as own_folder
from .writing import require_no_link as require_no_link
from .writing import require_unlocked as require_unlocked
from .writing import sweep as sweep
from .writing import temporary_folder as temporary_folder
from .writing import whole as whole
from .writing import write_atomic as write_atomic
from .yaml_text import load_yaml as load_yaml
from .yaml_text import parse_yaml as parse_yaml

"""The only place that opens files: what others wrote is bounded on the way in, what is ours is whole on the way out.

Whatever is wrong with a file raises InputError with one line that names the file and the fix. Nothing outside of this
floor opens files, archives, tables, images or meshes (``tests/io/test_one_door.py``).
"""

from .archives import is_plain_name as is_plain_name
from .archives import open_zip as open_zip
from .archives import read_arrays as read_arrays
from .errors import InputError as InputError
from .errors import MissingDependencyError as MissingDependencyError
from .errors import SceneWeaverError as SceneWeaverError
from .folders import Place as Place
from .folders import opened_folder as opened_folder
from .folders import require_no_link as require_no_link
from .images import open_image as open_image
from .json_text import load_json as load_json
from .json_text import load_json_lines as load_json_lines
from .json_text import load_packed_json as load_packed_json
from .json_text import parse_json as parse_json
from .meshes import read_mesh as read_mesh
from .meshes import read_meshes as read_meshes
from .mjcf import load_mjcf as load_mjcf
from .mjcf import read_spec as read_spec
from .reading import MAX_BYTES as MAX_BYTES
from .reading import MAX_UNPACKED as MAX_UNPACKED
from .reading import lines_unpacked as lines_unpacked
from .reading import open_regular as open_regular
from .reading import open_unpacked as open_unpacked
from .reading import read_bytes as read_bytes
from .reading import read_text as read_text
from .reading import read_unpacked as read_unpacked
from .reading import reason as reason
from .reading import sha256_of as sha256_of
from .references import named_inside as named_inside
from .references import required_inside as required_inside
from .tables import load_csv as load_csv
from .tables import open_csv as open_csv
from .tables import open_parquet as open_parquet
from .tables import parquet_rows as parquet_rows
from .usd import open_stage as open_stage
from .writing import SUFFIX as SUFFIX
from .writing import TEMPORARY as TEMPORARY
from .writing import bring_to_disk as bring_to_disk
from .writing import locked as locked
from .writing import open_writable as open_writable
from .writing import own_folder as own_folder
from .writing import require_unlocked as require_unlocked
from .writing import sweep as sweep
from .writing import temporary_folder as temporary_folder
from .writing import whole as whole
from .writing import write_atomic as write_atomic
from .xml_text import load_xml as load_xml
from .xml_text import parse_xml as parse_xml
from .yaml_text import dump_yaml as dump_yaml
from .yaml_text import load_yaml as load_yaml
from .yaml_text import parse_yaml as parse_yaml

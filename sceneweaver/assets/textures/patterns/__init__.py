"""The patterns themselves, one module a material; importing this package enters them all."""

from . import aged as _aged  # noqa: F401
from . import basketry as _basketry  # noqa: F401
from . import carpets as _carpets  # noqa: F401
from . import cloth as _cloth  # noqa: F401
from . import floors as _floors  # noqa: F401
from . import metals as _metals  # noqa: F401
from . import plants as _plants  # noqa: F401
from . import smooth as _smooth  # noqa: F401
from . import soft as _soft  # noqa: F401
from . import stones as _stones  # noqa: F401
from . import walls as _walls  # noqa: F401
from . import woods as _woods  # noqa: F401

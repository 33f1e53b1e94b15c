"""How bright a picture is shown, and what counts as white in it: from the light that falls on what is seen."""

from __future__ import annotations

import numpy as np

_WHITE = 0.47
"""Value, before tone mapping, of white paint in the middling light of a picture."""

_PAINT = 0.82
_EVERY = 5  # pixel that is looked at
_ADAPTED = 0.65  # share of the colour of the light that an eye gets used to


def exposed(soft: np.ndarray, key: np.ndarray) -> tuple[float, np.ndarray]:
    """Exposure, and the gains of red, green and blue [3].

    Args:
        soft: Light without that of the sun, over pi, RGB [N, 3].
        key: Negative where nothing is seen [N].
    """
    soft, key = soft[::_EVERY], key[::_EVERY]
    seen = key >= 0
    if not seen.any():
        return 1.0, np.ones(3)
    light = soft[seen].astype(np.float64)
    bright = light @ (0.2126, 0.7152, 0.0722)
    lit = bright > 1e-6
    if not lit.any():
        return 1.0, np.ones(3)
    low, high = np.quantile(bright[lit], (0.1, 0.9))
    middling = lit & (bright >= low) & (bright <= high)
    level = float(np.exp(np.log(bright[middling]).mean()))
    mean = light[middling].mean(axis=0)
    gains = (mean @ (0.2126, 0.7152, 0.0722) / np.maximum(mean, 1e-9)) ** _ADAPTED
    return _WHITE / (_PAINT * level), gains

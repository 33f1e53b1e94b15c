"""What relations and rules mean, as data: rows of a measure, the interval that it must lie in, and the frame of sides.

The lowest floor. `relations.yaml` holds the relation types of scenes, `stated.yaml` the words of requests, `measures`
lists what can be measured at all. Engine, judge, reader and critic read the same rows; none of them has numbers of its
own. Metres, degrees; sides are those of an object's own frame unless a row says the viewer's.
"""

from .expression import Expression as Expression
from .measures import MEASURES as MEASURES
from .measures import Measure as Measure

__all__ = ["MEASURES", "Expression", "Measure"]

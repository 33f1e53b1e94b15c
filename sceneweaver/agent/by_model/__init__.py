"""Reader, planner, tool inputs and critic that ask a model; everything that they decide is checked by code."""

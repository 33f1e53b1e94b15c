"""Other people's meshes: read, brought to our axes and unit, given collision parts and surfaces."""

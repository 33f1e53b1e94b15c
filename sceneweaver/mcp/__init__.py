"""A server of the Model Context Protocol: rooms for assistants to design, edit, check and render."""

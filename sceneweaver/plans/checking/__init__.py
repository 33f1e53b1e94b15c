"""What `sceneweaver.plans.check_plan` measures: integers in millimetres, shared with nothing that makes plans."""

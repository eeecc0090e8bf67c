"""What ``MoveItConfigsBuilder`` collects for MoveIt's nodes from the files of a package."""

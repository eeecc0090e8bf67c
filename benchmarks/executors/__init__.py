"""What becomes of a wait inside a callback, on a real rclpy and by archlint's word: one small program for each cell."""

"""Films: pictures drawn off screen, one after the other, encoded by a worker thread with PyAV."""

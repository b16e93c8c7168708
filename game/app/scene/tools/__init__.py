"""What one measures with: ruler, protractor and stop-watch over the picture, charts of any readout."""

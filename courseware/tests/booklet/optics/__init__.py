"""Where does a lens put the image of a candle?"""

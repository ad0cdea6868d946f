from hypothesis import settings

settings.register_profile("robokin", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("robokin")

"""The error of the framework: a wrong declaration or a wrong call."""


class CourseError(ValueError):
    """Its message says what was got, what is allowed, and what to do."""

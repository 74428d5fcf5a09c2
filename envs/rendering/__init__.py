"""Pictures of the house: the camera looks at a world, the renderer draws what it sees.

Only the camera is imported here, and it loads pygame and Pillow when the first picture is asked for.
"""

import os

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # a library does not print

from decomplex_bt.envs.rendering.camera import Camera
from decomplex_bt.envs.rendering.scene import Pose, Scene

__all__ = ["Camera", "Pose", "Scene"]

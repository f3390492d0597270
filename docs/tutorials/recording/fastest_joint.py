"""fastest_joint.py FILE: which joint of the arm moved fastest in a recording, and when."""
import sys

import numpy as np
import tendon

TABLE = "robot/arm/state"

with tendon.open(sys.argv[1]) as run:
    velocity = run[f"{TABLE}.Joints.velocity"]  # an array of rows x 7
    unit = run.unit(f"{TABLE}.Joints.velocity")
    times = run.times(TABLE)  # ns since 1970
    row, joint = np.unravel_index(np.abs(velocity).argmax(), velocity.shape)
    after = (times[row] - times[0]) / 1e9
    print(f"joint {joint} moved with {velocity[row, joint]:.3f} {unit} after {after:.3f} s")
    print(f"{len(times)} rows, {run.gaps(TABLE)['missing'].sum()} missing")

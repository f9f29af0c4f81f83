# SPDX-License-Identifier: MIT
# Label volumes as a user meets them.
import json

import volume_files
from program import COARSE, Program, main


class Labels(Program):
    def test_a_label_is_looked_at_where_the_volume_puts_it(self):
        """Two halves of an ellipsoid, which the affine brings to x from 5 to 28 in RAS, and so to -5 to -28 in LPS."""
        head, voxels = volume_files.nifti()[:352], volume_files.voxels()
        halves = bytes((1 if i % volume_files.SIZE[0] < 12 else 2) if voxel else 0 for i, voxel in enumerate(voxels))
        self.write("halves.nii", head + halves)

        def place(label):
            done = self.run_it("points", "halves.nii", "--json", *COARSE, "--label", label)
            return json.loads(done.stdout)["shape"]["points"][0]["position"][0]

        self.assertTrue(-17 < place("1") < -6)
        self.assertTrue(-27 < place("2") < -17)
        self.expect_message(3, "there is no label 3, but 1, 2", "points", "halves.nii", "--label", "3")
        self.expect_message(3, "halves.nii", "points", "halves.nii")


if __name__ == "__main__":
    main()

"""Where does the Python of a prefix find a package?  Arguments: the prefix, the suffix of the module that is to go there.

Asked of the prefix's own interpreter where it has one, else of the one that the module was built for; prints the folder."""

import site
import sys
import sysconfig
from pathlib import Path

prefix = Path(sys.argv[1])
suffix = sysconfig.get_config_var("EXT_SUFFIX")
if suffix != sys.argv[2]:
    sys.exit(f"plumb: {sys.executable} reads modules that end in {suffix}, and this one ends in {sys.argv[2]}; "
             f"configure with -DPython3_EXECUTABLE={sys.executable}")
beneath = [Path(folder) for folder in site.getsitepackages() if Path(folder).is_relative_to(prefix)]
# What is below `local` belongs to who administers the machine, not to this prefix.
own = [folder for folder in beneath if not folder.is_relative_to(prefix / "local")]
unknown = prefix / "lib" / f"python{sys.version_info.major}.{sys.version_info.minor}" / "site-packages"
print((own or [unknown])[0])

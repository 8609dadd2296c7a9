// fence.h - which files a model may include: those in the scene's own folder
// and in the folders of the include path. Where a file really is decides, not
// how it is written: neither .. nor a link leads out.

#import <Foundation/Foundation.h>

/** The folder behind all symbolic links, without . and ..; nil if there is
    none (autoreleased). "" is the current folder. */
NSString *fence_folder(NSString *path);

/** Whether a real path is one of the folders or lies in one. */
BOOL fence_holds(NSArray *folders, NSString *real);

/** Opens an ordinary file or a folder that lies in one of the folders
    (fence_folder). What does not is not opened at all, nor is a device or a
    pipe. -1 with errno if not: EXDEV for what lies outside, EINVAL for what is
    not ordinary. */
int fence_open(NSString *path, NSArray *folders);
